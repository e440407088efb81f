// A direction across another one.
#pragma once

#include "shabon/math/vec.h"

namespace shabon::math {

// Any unit vector normal to the unit vector `d`, the same for the same d.
inline Vec3d any_normal_to(const Vec3d& d) {
  return normalize(cross(d, std::abs(d.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
}

}  // namespace shabon::math
