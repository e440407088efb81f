// The CIE's formula for daylight of any correlated colour temperature, equation (41).
#pragma once

#include <array>

#include "shabon/base/field.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

// Where the formula holds.
inline constexpr Range daylight_range_kelvin{.low = 4000, .high = 25'000};

// CIE's D lamps bear the temperature they had while c2 was taken as 1.4380e-2 m K; on today's scale, of 1.4388e-2 m K,
// they are this much hotter: D65 is daylight of 6503.6 K. `daylight_power` takes today's.
inline constexpr double nominal_daylight_scale = 1.4388 / 1.4380;

// Its chromaticity (CIE 1931).
Xy daylight_chromaticity(double temperature_kelvin);

enum class DaylightWeights {
  exact,
  three_decimals,  // M1 and M2 rounded, as CIE 15:2018 (4.1.2) asks for D50, D55 and D75
};

// Relative power per nm, 100 at 560 nm, with straight lines between the components' values at 5 nm.
Spectrum daylight_power(double temperature_kelvin, DaylightWeights weights = DaylightWeights::exact);

// The components S0, S1 and S2 at 1 nm, as daylight_power() adds them.
std::array<Spectrum, 3> daylight_components();

}  // namespace shabon::color
