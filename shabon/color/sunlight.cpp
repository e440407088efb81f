#include "shabon/color/sunlight.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/units.h"
#include "shabon/color/table_columns.h"

// The numbers of this file: the paper's appendix A.1, after M. Iqbal, "An introduction to solar radiation", Academic
// Press 1983.
namespace shabon::color {

namespace {

enum Column : std::size_t { irradiance = 1, water_vapour, ozone, mixed_gases };

// Linear between the table's rows, which reach beyond the range of the spectra.
double at(Column column, double nm) {
  const Table& table = tables::sunlight().front();
  const auto wavelengths = table.columns[0], values = table.columns[column];
  const auto above = std::upper_bound(wavelengths.begin() + 1, wavelengths.end() - 1, nm);
  const auto right = static_cast<std::size_t>(above - wavelengths.begin());
  const double share = (nm - wavelengths[right - 1]) / (wavelengths[right] - wavelengths[right - 1]);
  return values[right - 1] + std::clamp(share, 0.0, 1.0) * (values[right] - values[right - 1]);
}

}  // namespace

double optical_air_mass(double elevation_deg) {
  const double zenith_deg = 90 - elevation_deg;
  return 1 / (std::cos(Radians(Degrees(zenith_deg)).value) + 0.15 * std::pow(93.885 - zenith_deg, -1.253));
}

AirTransmittance air_transmittance(double wavelength_nm, double air_mass, double turbidity) {
  constexpr double nm_per_um = 1000, angstrom_exponent = 1.3, ozone_cm = 0.35, water_cm = 2;
  const double um = wavelength_nm / nm_per_um, beta = 0.04608 * turbidity - 0.04586;
  const double gas = at(mixed_gases, wavelength_nm) * air_mass;
  const double water = at(water_vapour, wavelength_nm) * water_cm * air_mass;
  AirTransmittance share;
  share.molecules = std::exp(-0.008735 * std::pow(um, -4.08) * air_mass);
  share.aerosol = std::exp(-beta * std::pow(um, -angstrom_exponent) * air_mass);
  share.ozone = std::exp(-at(ozone, wavelength_nm) * ozone_cm * air_mass);
  share.mixed_gases = std::exp(-1.41 * gas / std::pow(1 + 118.93 * gas, 0.45));
  share.water_vapour = std::exp(-0.2385 * water / std::pow(1 + 20.07 * water, 0.45));
  return share;
}

Spectrum sun_irradiance_outside_the_air() {
  Spectrum result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = at(irradiance, wavelength_nm(i));
  return result;
}

Spectrum sun_irradiance(double elevation_deg, double turbidity) {
  const double air_mass = optical_air_mass(elevation_deg);
  Spectrum result = sun_irradiance_outside_the_air();
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] *= air_transmittance(wavelength_nm(i), air_mass, turbidity).all();
  return result;
}

}  // namespace shabon::color
