#include "shabon/optics/reference/phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::optics {

std::complex<double> Passage::factor() const { return std::polar(std::exp(-loss), phase_rad); }

Passage passage(std::complex<double> normal_index, double thickness_nm, double wavelength_nm) {
  constexpr double two_pi = 2 * std::numbers::pi;
  const double phase_cycles = normal_index.real() * thickness_nm / wavelength_nm;
  const double loss_cycles = normal_index.imag() * thickness_nm / wavelength_nm;
  return {two_pi * (phase_cycles - std::round(phase_cycles)), two_pi * std::max(0.0, loss_cycles)};
}

}  // namespace shabon::optics
