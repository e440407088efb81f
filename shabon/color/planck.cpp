#include "shabon/color/planck.h"

#include <cmath>

namespace shabon::color {

Spectrum blackbody_power(double temperature_kelvin) {
  constexpr double normal_nm = 560, normal_power = 100;  // CIE 15:2018, 4.1
  const double c2_over_t = second_radiation_constant_nm_kelvin / temperature_kelvin;
  const double normal = std::expm1(c2_over_t / normal_nm);
  Spectrum power;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double lambda = wavelength_nm(i);
    power[i] = normal_power * std::pow(normal_nm / lambda, 5) * (normal / std::expm1(c2_over_t / lambda));
  }
  return power;
}

}  // namespace shabon::color
