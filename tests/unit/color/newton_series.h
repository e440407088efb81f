// Newton's colours of a free film of water in air at normal incidence, for tests that need many film colours.
// `gain` stands for a brighter lamp.
#pragma once

#include <cmath>
#include <numbers>

#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"

inline shabon::color::LinearRgb newton_colour(
    double thickness_nm, double gain = 1,
    const shabon::color::Illuminant& lamp = *shabon::color::find_illuminant("D65"), bool transmitted = false) {
  using namespace shabon::color;
  constexpr double water = 1.333;
  const double rho = std::pow((water - 1) / (water + 1), 2);
  Spectrum spectrum;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double half_delta = 2 * std::numbers::pi * water * thickness_nm / wavelength_nm(i);
    const double f = 4 * rho * std::pow(std::sin(half_delta), 2) / std::pow(1 - rho, 2);  // equation (10)
    spectrum[i] = gain * (transmitted ? 1 : f) / (1 + f);
  }
  return xyz_to_linear_srgb(reflectance_to_xyz(spectrum, lamp));
}
