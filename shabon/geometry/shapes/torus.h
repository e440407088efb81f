// A closed ring of round tube about the y axis: its middle line has the radius 1.
#pragma once

#include <optional>
#include <string_view>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Normal outward; u is the azimuth, v goes around the tube from its top outwards. `tube` is the radius of
// the tube, in (0, 1).
struct Torus {
  static constexpr std::string_view name = "torus";
  static constexpr bool flat = false;
  double tube = 0.1;
};

inline double area(const Torus& torus) { return 4 * std::numbers::pi * std::numbers::pi * torus.tube; }

inline double support(const Torus& torus, math::Vec3d g) { return std::hypot(g.x, g.z) + torus.tube * math::length(g); }

// The roots of a polynomial of the fourth degree, each between two places where its slope is 0, by Newton's method on
// the distance from the tube, which keeps its digits however thin the tube is.
std::optional<double> next_crossing(const Torus& torus, math::Vec3d origin, math::Vec3d direction, bool starts_on_it);

inline CanonicalPoint point_at(const Torus& torus, math::Vec3d p) {
  const double from_axis = std::hypot(p.x, p.z);
  const math::Vec3d outward = from_axis > 0 ? math::Vec3d{p.x / from_axis, 0, p.z / from_axis} : math::Vec3d{0, 0, -1};
  const math::Vec3d from_line{p.x - outward.x, p.y, p.z - outward.z};
  const double distance = math::length(from_line);
  const math::Vec3d normal = distance > 0 ? from_line * (1 / distance) : outward;
  const double turn = std::atan2(dot(from_line, outward), p.y) / (2 * std::numbers::pi);
  return {outward + normal * torus.tube, normal, azimuth_tangent(outward.x, outward.z), azimuth_u(outward.x, outward.z),
          turn < 0 ? std::min(turn + 1, 1.0) : turn};
}

// Uniform over both angles, so denser inside the ring.
inline math::Vec3d sample(const Torus& torus, double u1, double u2) {
  const double around = 2 * std::numbers::pi * u1, azimuth = 2 * std::numbers::pi * u2;
  const double from_axis = 1 + torus.tube * std::sin(around);
  return {from_axis * std::sin(azimuth), torus.tube * std::cos(around), -from_axis * std::cos(azimuth)};
}

inline double area_per_sample(const Torus& torus, math::Vec3d p) { return area(torus) * std::hypot(p.x, p.z); }

}  // namespace shabon::geometry
