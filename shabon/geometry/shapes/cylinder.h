// An open tube: radius 1 about the y axis, from y = -1 to y = 1.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Normal outward; u is the azimuth, v = (1-y)/2 from the top. Disks close its ends.
struct Cylinder {
  static constexpr std::string_view name = "cylinder";
  static constexpr bool flat = false;
};

inline double area(const Cylinder&) { return 4 * std::numbers::pi; }

inline double support(const Cylinder&, math::Vec3d g) { return std::abs(g.y) + std::hypot(g.x, g.z); }

inline std::optional<double> next_crossing(const Cylinder&, math::Vec3d origin, math::Vec3d direction,
                                           bool starts_on_it) {
  const double squared = direction.x * direction.x + direction.z * direction.z;
  const double middle = -(origin.x * direction.x + origin.z * direction.z) / squared;
  std::array<double, 2> roots{0, 2 * middle};
  if (!starts_on_it) {
    // The ray's distance from the axis times the root of `squared`, without a difference of large numbers.
    const double moment = origin.x * direction.z - origin.z * direction.x;
    const double half_squared = (1 - moment * moment / squared) / squared;
    if (!(half_squared >= 0)) return {};
    const double half = std::sqrt(half_squared);
    roots = {middle - half, middle + half};
  }
  for (const double root : roots)
    if (root > 0 && std::abs(origin.y + root * direction.y) <= 1) return root;
  return {};
}

inline CanonicalPoint point_at(const Cylinder&, math::Vec3d p) {
  const double r = std::hypot(p.x, p.z);
  const math::Vec3d normal{p.x / r, 0, p.z / r};
  const double v = std::clamp((1 - p.y) / 2, 0.0, 1.0);
  return {{normal.x, p.y, normal.z}, normal, azimuth_tangent(p.x, p.z), azimuth_u(p.x, p.z), v};
}

inline math::Vec3d sample(const Cylinder&, double u1, double u2) {
  const double phi = 2 * std::numbers::pi * u2;
  return {std::sin(phi), 1 - 2 * u1, -std::cos(phi)};
}

}  // namespace shabon::geometry
