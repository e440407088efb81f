// Where light comes from, seen from a point: directions towards lamps, chosen at random, and how likely each was.
#pragma once

#include <optional>
#include <vector>

#include "shabon/geometry/shape.h"
#include "shabon/math/vec.h"
#include "shabon/scene/scene.h"

namespace shabon::render {

// Directions on the sphere in proportion to a latitude-longitude table of brightness.
class DirectionTable {
 public:
  // The brightness of cells from the top row; (u, v) as in equation (25) without rotation.
  DirectionTable(int width, int height, const std::vector<double>& brightness);

  math::Vec3d sample(double u1, double u2) const;
  double pdf(const math::Vec3d& direction) const;  // per solid angle

 private:
  int width_, height_;
  std::vector<double> solid_angles_;  // of a cell in each row
  std::vector<double> rows_;          // cumulative, height_ + 1
  std::vector<double> columns_;       // cumulative in each row, height_ * (width_ + 1)
};

struct LampDirection {
  math::Vec3d direction;
  double distance = 0;  // infinite for lamps at infinity
  int object = -1;      // Scene::objects of the lamp, -1 for lamps at infinity
  double pdf = 0;       // per solid angle, of all lamps at infinity together or of this object
};

class LampSampling {
 public:
  explicit LampSampling(const scene::Scene& scene);

  bool has_lamps() const { return !lamps_.empty() || infinity_brightness_ > 0; }

  // One direction seen from `point`; nothing where chance finds none. u are in [0, 1).
  std::optional<LampDirection> sample(const math::Vec3d& point, double u_lamp, double u1, double u2) const;

  // How likely sample() is to find the light at infinity in `direction`, or the point of a lamp at `distance`.
  double pdf_infinity(const math::Vec3d& point, const math::Vec3d& direction) const;
  double pdf_object(const math::Vec3d& point, int object, const math::Vec3d& direction, double distance) const;

 private:
  struct ObjectLamp {
    int object;
    double power;  // Y times area
    math::Vec3d center;
    double area;
    double brightness;
  };
  struct Softbox {
    std::size_t index;
    double share;  // of the light at infinity
    double solid_angle;
  };

  double weight(const ObjectLamp& lamp, const math::Vec3d& point) const;
  double share_of_infinity(const math::Vec3d& point, double* total) const;
  double direction_density(const math::Vec3d& direction) const;

  const scene::Scene& scene_;
  std::vector<ObjectLamp> lamps_;
  std::vector<int> lamp_of_object_;  // -1 where the object is no lamp
  std::vector<Softbox> softboxes_;
  std::optional<DirectionTable> base_;
  double base_share_ = 0;
  double infinity_brightness_ = 0;  // Y of its irradiance, as seen without anything in between
};

}  // namespace shabon::render
