#include "shabon/desk/retardation.h"

#include <cmath>
#include <numbers>

namespace shabon::desk {

double retardation_nm(double birefringence, double thickness_nm) { return birefringence * thickness_nm; }

color::Spectrum crossed_polars_share(double retardation_nm) {
  color::Spectrum share;
  for (std::size_t i = 0; i < share.size(); ++i) {
    // Whole cycles first: they keep all digits of a large retardation.
    const double cycles = retardation_nm / color::wavelength_nm(i);
    const double amplitude = std::sin(std::numbers::pi * (cycles - std::round(cycles)));
    share[i] = amplitude * amplitude;
  }
  return share;
}

std::vector<color::Xyz> retardation_colors(std::span<const double> retardations_nm, const color::Illuminant& lamp,
                                           const color::Observer& observer) {
  std::vector<color::Xyz> colors;
  colors.reserve(retardations_nm.size());
  for (const double retardation_nm : retardations_nm)
    colors.push_back(color::reflectance_to_xyz(crossed_polars_share(retardation_nm), lamp, observer));
  return colors;
}

}  // namespace shabon::desk
