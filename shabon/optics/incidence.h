// The direction in which light meets a plane stack: the angle between ray and normal in the first medium.
#pragma once

#include "shabon/base/units.h"

namespace shabon::optics {

struct Incidence {
  double cos_i = 1;  // 0..1
  double sin_i = 0;  // 0..1
};

// From an angle, 0..90 degrees. 90 degrees gives cos_i = 0 exactly, and near it cos_i keeps all its digits.
Incidence incidence_from(Degrees angle);

// From a cosine, 0..1.
Incidence incidence_from_cos(double cos_i);

}  // namespace shabon::optics
