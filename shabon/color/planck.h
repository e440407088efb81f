// The spectrum of a blackbody, equation (40).
#pragma once

#include "shabon/base/field.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

// Second radiation constant h c / k in nm K, from the exact values of the SI of 2019: h = 6.62607015e-34 J s,
// c = 299792458 m/s, k = 1.380649e-23 J/K.
inline constexpr double second_radiation_constant_nm_kelvin = 6.62607015e-34 * 299792458 / 1.380649e-23 * 1e9;

// Temperatures for which a spectrum over 360..830 nm is of use.
inline constexpr Range blackbody_range_kelvin{.low = 1000, .high = 100'000};

// Relative power per nm (in vacuum), 100 at 560 nm as the CIE's lamps have it. `temperature_kelvin` > 0.
Spectrum blackbody_power(double temperature_kelvin);

}  // namespace shabon::color
