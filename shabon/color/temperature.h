// Correlated colour temperature, equation (42).
#pragma once

#include <optional>

#include "shabon/color/xyz.h"

namespace shabon::color {

struct ColorTemperature {
  double kelvin = 0;
  double duv = 0;  // distance from the blackbodies in CIE 1960 (u, v); positive on their green side
};

// The temperature of the blackbody nearest in CIE 1960 (u, v), for the CIE 1931 observer (CIE 15:2018, 9.5), to 0.01 K
// at 10 000 K. Nothing where it would mean nothing: farther than 0.05 from every blackbody, or colder than 1000 K or
// hotter than 100 000 K.
std::optional<ColorTemperature> correlated_color_temperature(Xy chromaticity);

}  // namespace shabon::color
