// A disk, or a ring: the unit disk in the xy plane.
#pragma once

#include <optional>
#include <string_view>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Normal +z; u and v as those of the square around it. `hole` is the radius of a round hole, in [0, 1).
struct Disk {
  static constexpr std::string_view name = "disk";
  static constexpr bool flat = true;
  double hole = 0;
};

inline double area(const Disk& disk) { return std::numbers::pi * (1 - disk.hole) * (1 + disk.hole); }

inline double support(const Disk&, math::Vec3d g) { return std::hypot(g.x, g.y); }

inline std::optional<double> next_crossing(const Disk& disk, math::Vec3d origin, math::Vec3d direction,
                                           bool starts_on_it) {
  const double distance = -origin.z / direction.z;
  if (starts_on_it || !(distance > 0)) return {};
  const double x = origin.x + distance * direction.x, y = origin.y + distance * direction.y;
  const double r_squared = x * x + y * y;
  if (!(r_squared <= 1 && r_squared >= disk.hole * disk.hole)) return {};
  return distance;
}

inline CanonicalPoint point_at(const Disk&, math::Vec3d p) { return on_square(p.x, p.y); }

inline math::Vec3d sample(const Disk& disk, double u1, double u2) {
  const double hole_squared = disk.hole * disk.hole;
  const double r = std::sqrt(hole_squared + u1 * (1 - hole_squared)), phi = 2 * std::numbers::pi * u2;
  return {r * std::cos(phi), r * std::sin(phi), 0};
}

}  // namespace shabon::geometry
