// What every canonical shape answers, in its own coordinates. Each file of this folder has one struct with a `name`,
// whether it is `flat` (in the plane z = 0), and five functions of it:
//   area          exact
//   support       the largest dot(g, p) over the points p of the shape, for any g: its extent in a direction
//   next_crossing the least distance > 0 at which the ray origin + distance direction meets the shape, in units of the
//                 direction, which may have any length; for a ray that starts on the shape the other crossing
//   point_at      the point of the shape at `p`, which is on it but for rounding
//   sample        a point that is uniform over the area, from two numbers in [0, 1]
// A shape whose sample() is not uniform has a sixth, area_per_sample: the inverse of the density of sample() at a point
// of it, per area. One that is `by_direction` gives places by their direction from its origin, not within its box.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/math/vec.h"

namespace shabon::geometry {

struct CanonicalPoint {
  math::Vec3d position;
  math::Vec3d normal;     // unit, outward or front
  math::Vec3d tangent_u;  // in the direction of rising u; unit for the canonical shape
  double u = 0, v = 0;    // 0..1
};

// The square [-1,1]^2 on the texture: u to the right, v downwards.
inline CanonicalPoint on_square(double x, double y) {
  const double u = std::clamp((x + 1) / 2, 0.0, 1.0), v = std::clamp((1 - y) / 2, 0.0, 1.0);
  return {{x, y, 0}, {0, 0, 1}, {1, 0, 0}, u, v};
}

// The azimuth about y as environment pictures count it: 0.5 in the direction -z, more towards +x. 0..1.
inline double azimuth_u(double x, double z) {
  return std::clamp(0.5 + std::atan2(x, -z) / (2 * std::numbers::pi), 0.0, 1.0);
}

// The direction in which the azimuth about y rises; some direction on the axis itself.
inline math::Vec3d azimuth_tangent(double x, double z) {
  const double r = std::hypot(x, z);
  if (!(r > 0)) return {1, 0, 0};
  return {-z / r, 0, x / r};
}

}  // namespace shabon::geometry
