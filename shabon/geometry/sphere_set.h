// All spheres of a scene and the next wall that a ray meets. Embree finds the candidates; the crossing itself is
// computed in double by sphere.h, so that a few spheres looked at one by one give the same answer.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shabon/geometry/sphere.h"

namespace shabon::geometry {

inline constexpr int no_sphere = -1;

struct WallHit {
  double distance = 0;
  int sphere = no_sphere;
};

// How the next wall is found. The answer is the same.
enum class WallSearch { by_number, one_by_one, tree };

class SphereSet {
 public:
  // Up to this many spheres are looked at one by one: that is faster than a tree (bench/geometry measures it).
  static constexpr int few = 32;

  explicit SphereSet(std::vector<SphereShape> spheres, WallSearch search = WallSearch::by_number);
  ~SphereSet();
  SphereSet(SphereSet&&) noexcept;
  SphereSet& operator=(SphereSet&&) noexcept;

  // The first wall in front of `origin` along the unit vector `direction`. A ray that starts on the wall of sphere
  // `from` does not meet that wall again, only its other side. At equal distances the sphere listed first is met first.
  std::optional<WallHit> next_wall(math::Vec3d origin, math::Vec3d direction, int from = no_sphere) const;

  // The same for a caller who keeps account of the spheres that hold the ray: `holding`, in rising order. Those must be
  // left and the others may be entered, so rounding cannot lose a wall, or meet it twice, where several share a point.
  std::optional<WallHit> next_wall(math::Vec3d origin, math::Vec3d direction, int from,
                                   std::span<const int> holding) const;

  std::span<const SphereShape> spheres() const { return spheres_; }
  // Whether the spheres are looked at one by one.
  bool has_few() const { return tree_ == nullptr; }

 private:
  struct Tree;
  struct Query;
  std::optional<WallHit> nearest_of(Query& query) const;

  std::vector<SphereShape> spheres_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace shabon::geometry
