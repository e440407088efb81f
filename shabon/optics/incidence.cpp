#include "shabon/optics/incidence.h"

#include <algorithm>
#include <cmath>

namespace shabon::optics {

Incidence incidence_from(Degrees angle) {
  // The complement is exact in degrees; its sine keeps the digits that a cosine near 90 degrees loses.
  const Radians complement = Degrees(90 - angle.value);
  return {std::max(0.0, std::sin(complement.value)), std::max(0.0, std::sin(Radians(angle).value))};
}

Incidence incidence_from_cos(double cos_i) { return {cos_i, std::sqrt(std::max(0.0, (1 - cos_i) * (1 + cos_i)))}; }

}  // namespace shabon::optics
