// Tristimulus values by plain sums at 1 nm, both ends with full weight: equation (17).
#pragma once

#include <span>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

struct Xyz {
  double x = 0, y = 0, z = 0;
  constexpr bool operator==(const Xyz&) const = default;
};

// Chromaticity coordinates.
struct Xy {
  double x = 0, y = 0;
  constexpr bool operator==(const Xy&) const = default;
};

// X = sum L xbar, and so on. A lamp_radiance() has Y = 1 under the same observer.
Xyz radiance_to_xyz(std::span<const double, 471> radiance, const Observer& observer = observer_1931());

// X = sum S R xbar / sum S ybar, and so on: the perfect reflector, R = 1, has Y = 1. No chromatic adaptation.
Xyz reflectance_to_xyz(std::span<const double, 471> reflectance, const Illuminant& lamp,
                       const Observer& observer = observer_1931());

// The perfect reflector under the lamp; the white of Lab.
Xyz white_point(const Illuminant& lamp, const Observer& observer = observer_1931());

// x = X/(X+Y+Z), y = Y/(X+Y+Z). Black has no chromaticity: where the sum is not positive both are 0.
Xy chromaticity(Xyz colour);

}  // namespace shabon::color
