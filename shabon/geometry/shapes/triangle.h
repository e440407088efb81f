// A triangle: the corners (0,0,0), (1,0,0), (0,1,0).
#pragma once

#include <optional>
#include <string_view>

#include "shabon/geometry/affine.h"
#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Normal +z; u = x, v = 1-y.
struct Triangle {
  static constexpr std::string_view name = "triangle";
  static constexpr bool flat = true;
};

// The map that puts the corners of the canonical triangle at a, b, c. Its front is where they run anticlockwise. The
// corners must not lie on one line.
inline Affine triangle_placement(math::Vec3d a, math::Vec3d b, math::Vec3d c) {
  const math::Vec3d across = cross(b - a, c - a);
  return {b - a, c - a, across * (1 / std::sqrt(math::length(across))), a};
}

inline double area(const Triangle&) { return 0.5; }

inline double support(const Triangle&, math::Vec3d g) { return std::max({0.0, g.x, g.y}); }

inline std::optional<double> next_crossing(const Triangle&, math::Vec3d origin, math::Vec3d direction,
                                           bool starts_on_it) {
  const double distance = -origin.z / direction.z;
  if (starts_on_it || !(distance > 0)) return {};
  const double x = origin.x + distance * direction.x, y = origin.y + distance * direction.y;
  if (!(x >= 0 && y >= 0 && x + y <= 1)) return {};
  return distance;
}

inline CanonicalPoint point_at(const Triangle&, math::Vec3d p) {
  return {{p.x, p.y, 0}, {0, 0, 1}, {1, 0, 0}, std::clamp(p.x, 0.0, 1.0), std::clamp(1 - p.y, 0.0, 1.0)};
}

inline math::Vec3d sample(const Triangle&, double u1, double u2) {
  const double r = std::sqrt(u1);
  return {1 - r, u2 * r, 0};
}

}  // namespace shabon::geometry
