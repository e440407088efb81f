// Random points and directions for the tests of rays.
#pragma once

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/math/vec.h"

namespace shabon::geometry {

inline math::Vec3d random_direction(Pcg32& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
  return math::normalize(math::Vec3d{r * std::cos(angle), r * std::sin(angle), z});
}

inline math::Vec3d random_point(Pcg32& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

}  // namespace shabon::geometry
