// The direct light of the sun at the ground: A. J. Preetham, P. Shirley, B. Smits, "A practical analytic model for
// daylight", SIGGRAPH 1999, appendix A.1, with the absorption coefficients of data/sunlight.csv, which reach 830 nm.
#pragma once

#include "shabon/base/field.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

// Where the model of the sky was fitted: from a very clear to a hazy day.
inline constexpr Range turbidity_range{.low = 2, .high = 10};

// The mean angular radius of the sun, 0.533 degrees across.
inline constexpr double sun_half_angle_deg = 0.2665;

// How much more air the light crosses than from the zenith (1), at most 37 at the horizon. Elevation 0..90 degrees.
double optical_air_mass(double elevation_deg);

// Shares of the direct light that pass each of the atmosphere's parts.
struct AirTransmittance {
  double molecules = 1;  // Rayleigh scattering
  double aerosol = 1;    // Angstrom's turbidity formula
  double ozone = 1, mixed_gases = 1, water_vapour = 1;

  double all() const { return molecules * aerosol * ozone * mixed_gases * water_vapour; }
};

AirTransmittance air_transmittance(double wavelength_nm, double air_mass, double turbidity);

// Irradiance in W/(m^2 nm) on a surface that faces the sun.
Spectrum sun_irradiance(double elevation_deg, double turbidity);
Spectrum sun_irradiance_outside_the_air();

}  // namespace shabon::color
