// All shapes of a scene and the next one that a ray meets. Embree finds the candidates; the crossing itself is computed
// in double by shape.h, so that a few shapes looked at one by one give the same answer.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shabon/geometry/shape.h"

namespace shabon::geometry {

inline constexpr int no_shape = -1;

struct ShapeHit {
  double distance = 0;
  int shape = no_shape;
};

// How the next shape is found. The answer is the same.
enum class ShapeSearch { by_number, one_by_one, tree };

class ShapeSet {
 public:
  // Up to this many shapes are looked at one by one: that is faster than a tree (bench/geometry measures it).
  static constexpr int few = 8;

  explicit ShapeSet(std::vector<PlacedShape> shapes, ShapeSearch search = ShapeSearch::by_number);
  ~ShapeSet();
  ShapeSet(ShapeSet&&) noexcept;
  ShapeSet& operator=(ShapeSet&&) noexcept;

  // The first crossing in front of `origin` along the unit vector `direction`, if it is nearer than `limit`. A ray that
  // starts on the shape `from` meets only its other crossing. At equal distances the shape listed first is met first.
  // Threads may ask at the same time.
  std::optional<ShapeHit> next(math::Vec3d origin, math::Vec3d direction, int from = no_shape,
                               double limit = std::numeric_limits<double>::infinity()) const;

  std::span<const PlacedShape> shapes() const { return shapes_; }
  // Whether the shapes are looked at one by one.
  bool has_few() const { return tree_ == nullptr; }

 private:
  struct Tree;
  struct Query;

  std::vector<PlacedShape> shapes_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace shabon::geometry
