// Affine maps: where a shape stands, how it is turned and how large it is.
#pragma once

#include <cmath>
#include <numbers>

#include "shabon/math/vec.h"

namespace shabon::geometry {

// p -> x p.x + y p.y + z p.z + origin: the columns are the images of the axes.
struct Affine {
  math::Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  math::Vec3d origin;
  friend bool operator==(const Affine&, const Affine&) = default;
};

inline math::Vec3d apply_vector(const Affine& map, math::Vec3d v) { return map.x * v.x + map.y * v.y + map.z * v.z; }

inline math::Vec3d apply_point(const Affine& map, math::Vec3d p) { return apply_vector(map, p) + map.origin; }

// v by the transposed linear part: dot(apply_transposed(map, a), b) = dot(a, apply_vector(map, b)).
inline math::Vec3d apply_transposed(const Affine& map, math::Vec3d v) {
  return {dot(map.x, v), dot(map.y, v), dot(map.z, v)};
}

// Negative: the map mirrors.
inline double determinant(const Affine& map) { return dot(map.x, cross(map.y, map.z)); }

// A vector across a piece of surface, as long as the piece is large, where the map puts it: the inverse transpose times
// the determinant. It needs no inverse, and its length for a unit normal is the factor by which areas grow there.
inline math::Vec3d apply_area_vector(const Affine& map, math::Vec3d a) {
  return cross(map.y, map.z) * a.x + cross(map.z, map.x) * a.y + cross(map.x, map.y) * a.z;
}

// The unit normal of a surface that had the normal `n`, by the inverse transpose: what pointed out of a body still
// does.
inline math::Vec3d apply_normal(const Affine& map, math::Vec3d n) {
  const math::Vec3d across = math::normalize(apply_area_vector(map, n));
  return determinant(map) < 0 ? -across : across;
}

// The map back. The determinant must not be zero.
inline Affine inverse(const Affine& map) {
  const double d = 1 / determinant(map);
  const math::Vec3d rx = cross(map.y, map.z) * d, ry = cross(map.z, map.x) * d, rz = cross(map.x, map.y) * d;
  const math::Vec3d o = map.origin;
  return {{rx.x, ry.x, rz.x}, {rx.y, ry.y, rz.y}, {rx.z, ry.z, rz.z}, {-dot(rx, o), -dot(ry, o), -dot(rz, o)}};
}

// `second` after `first`.
inline Affine compose(const Affine& second, const Affine& first) {
  return {apply_vector(second, first.x), apply_vector(second, first.y), apply_vector(second, first.z),
          apply_point(second, first.origin)};
}

// Cosine and sine of an angle in degrees, exact at the multiples of 90: walls that should be level are.
struct Turn {
  double cosine, sine;
};

inline Turn turn_by(double angle_deg) {
  const double rest_deg = std::remainder(angle_deg, 90.0);  // exact
  const double quarters = std::remainder(std::round((angle_deg - rest_deg) / 90), 4.0);
  const double rest = rest_deg * (std::numbers::pi / 180);
  const double c = std::cos(rest), s = std::sin(rest);
  if (quarters == 0) return {c, s};
  if (quarters == 1) return {-s, c};
  if (quarters == -1) return {s, -c};
  return {-c, -s};
}

// First scaled along the axes, then turned by `rotation_deg` about the world's x, then its y, then its z axis
// (right-handed: y turns towards z about x, z towards x about y, x towards y about z), then moved.
inline Affine placement(math::Vec3d position, math::Vec3d rotation_deg = {}, math::Vec3d scale = {1, 1, 1}) {
  const auto [cx, sx] = turn_by(rotation_deg.x);
  const auto [cy, sy] = turn_by(rotation_deg.y);
  const auto [cz, sz] = turn_by(rotation_deg.z);
  const math::Vec3d x{cz * cy, sz * cy, -sy};
  const math::Vec3d y{cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx};
  const math::Vec3d z{cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx};
  return {x * scale.x, y * scale.y, z * scale.z, position};
}

}  // namespace shabon::geometry
