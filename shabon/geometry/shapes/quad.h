// A rectangle: the square [-1,1]^2 in the xy plane.
#pragma once

#include <optional>
#include <string_view>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Normal +z; u to the right, v downwards from the top: u = (x+1)/2, v = (1-y)/2.
struct Quad {
  static constexpr std::string_view name = "quad";
  static constexpr bool flat = true;
};

inline double area(const Quad&) { return 4; }

inline double support(const Quad&, math::Vec3d g) { return std::abs(g.x) + std::abs(g.y); }

inline std::optional<double> next_crossing(const Quad&, math::Vec3d origin, math::Vec3d direction, bool starts_on_it) {
  const double distance = -origin.z / direction.z;
  if (starts_on_it || !(distance > 0)) return {};
  const double x = origin.x + distance * direction.x, y = origin.y + distance * direction.y;
  if (!(std::abs(x) <= 1 && std::abs(y) <= 1)) return {};  // also where a parallel ray gives infinity
  return distance;
}

inline CanonicalPoint point_at(const Quad&, math::Vec3d p) { return on_square(p.x, p.y); }

inline math::Vec3d sample(const Quad&, double u1, double u2) { return {2 * u1 - 1, 1 - 2 * u2, 0}; }

}  // namespace shabon::geometry
