// The unit sphere about the origin, or the part of it above a height: a cap, of which two make a lens.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// The part with y >= cos_cap; -1 is the whole sphere. In [-1, 1). Normal outward; u is the azimuth, v = acos(y)/pi from
// the top.
struct SphereCap {
  static constexpr std::string_view name = "sphere";
  static constexpr bool flat = false;
  double cos_cap = -1;

  bool is_whole() const { return cos_cap <= -1; }
};

inline double area(const SphereCap& cap) { return 2 * std::numbers::pi * (1 - std::max(-1.0, cap.cos_cap)); }

inline double support(const SphereCap& cap, math::Vec3d g) {
  const double norm = math::length(g);
  if (cap.is_whole() || g.y >= cap.cos_cap * norm) return norm;
  const double c = cap.cos_cap;
  return c * g.y + std::sqrt((1 - c) * (1 + c)) * std::hypot(g.x, g.z);  // on the rim
}

// Which of two distances along a ray, in rising order, meets the part that exists.
inline std::optional<double> first_on_cap(const SphereCap& cap, std::array<double, 2> roots, double origin_y,
                                          double direction_y) {
  for (const double root : roots)
    if (root > 0 && (cap.is_whole() || origin_y + root * direction_y >= cap.cos_cap)) return root;
  return {};
}

inline std::optional<double> next_crossing(const SphereCap& cap, math::Vec3d origin, math::Vec3d direction,
                                           bool starts_on_it) {
  const double squared = dot(direction, direction);
  const double middle = -dot(origin, direction) / squared;
  if (starts_on_it) return first_on_cap(cap, {0, 2 * middle}, origin.y, direction.y);
  const math::Vec3d across = origin + direction * middle;
  const double half_squared = (1 - dot(across, across)) / squared;
  if (!(half_squared >= 0)) return {};
  const double half = std::sqrt(half_squared);
  return first_on_cap(cap, {middle - half, middle + half}, origin.y, direction.y);
}

inline CanonicalPoint point_at(const SphereCap&, math::Vec3d p) {
  const math::Vec3d n = math::normalize(p);
  const double v = std::acos(std::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
  return {n, n, azimuth_tangent(n.x, n.z), azimuth_u(n.x, n.z), v};
}

inline math::Vec3d sample(const SphereCap& cap, double u1, double u2) {
  const double below_top = u1 * (1 - std::max(-1.0, cap.cos_cap));  // Archimedes: uniform in height
  const double r = std::sqrt(below_top * (2 - below_top)), phi = 2 * std::numbers::pi * u2;
  return {r * std::sin(phi), 1 - below_top, -r * std::cos(phi)};
}

}  // namespace shabon::geometry
