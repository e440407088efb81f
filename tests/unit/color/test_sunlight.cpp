// Sunlight through the air, against independent formulas and figures.
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/color/daylight.h"
#include "shabon/color/sunlight.h"
#include "shabon/color/xyz.h"

namespace shabon::color {
namespace {

constexpr double lumens_per_watt = 683;

double klx(const Spectrum& irradiance) { return lumens_per_watt * radiance_to_xyz(irradiance).y / 1000; }

// J. E. Hansen, L. D. Travis, "Light scattering in planetary atmospheres", Space Sci. Rev. 16 (1974) 527,
// equation 2.30: the optical thickness of the molecules, from first principles. The power law of the model is a fit to
// within 4 %.
TEST(Sunlight, MoleculesScatterAsRayleighSays) {
  for (double nm = 360; nm <= 830; nm += 10) {
    const double um2 = nm * nm * 1e-6;
    const double depth = 0.008569 / (um2 * um2) * (1 + 0.0113 / um2 + 0.00013 / (um2 * um2));
    const double found = -std::log(air_transmittance(nm, 1, 2).molecules);
    EXPECT_NEAR(found / depth, 1, 0.04) << nm;
    EXPECT_NEAR(-std::log(air_transmittance(nm, 2.5, 2).molecules), 2.5 * found, 1e-12) << nm;
  }
  EXPECT_NEAR(air_transmittance(550, 1, 2).molecules, 0.9047, 1e-4);  // exp(-0.008735 0.55^-4.08), by hand
}

TEST(Sunlight, AirMassIsTheSecantUntilTheHorizon) {
  EXPECT_NEAR(optical_air_mass(90), 1, 1e-3);
  EXPECT_NEAR(optical_air_mass(30), 2, 0.01);
  // F. Kasten, Arch. Met. Geoph. Biokl. B 14 (1965) 206: 5.6 at 10 degrees, 10.4 at 5 degrees, 36.5 at the horizon.
  EXPECT_NEAR(optical_air_mass(10), 5.6, 0.05);
  EXPECT_NEAR(optical_air_mass(5), 10.4, 0.1);
  EXPECT_NEAR(optical_air_mass(0), 36.5, 0.1);
}

TEST(Sunlight, OutsideTheAirItHasTheSolarIlluminance) {
  EXPECT_NEAR(klx(sun_irradiance_outside_the_air()), 131, 4);  // published values lie between 127.5 and 134 klx
  const Spectrum outside = sun_irradiance_outside_the_air();
  EXPECT_EQ(outside[0], 0.9759);
  EXPECT_EQ(outside[550 - first_nm], 1.892);
  EXPECT_NEAR(outside[560 - first_nm], (1.892 + 1.84) / 2, 1e-12);
}

TEST(Sunlight, GrowsRedderAndWeakerTowardsTheHorizonAndWithHaze) {
  for (double turbidity = turbidity_range.low; turbidity <= turbidity_range.high; ++turbidity) {
    double illuminance = klx(sun_irradiance_outside_the_air());
    double x = chromaticity(radiance_to_xyz(sun_irradiance_outside_the_air())).x;
    for (const double elevation : {90.0, 60.0, 30.0, 10.0, 5.0, 0.0}) {
      const Spectrum here = sun_irradiance(elevation, turbidity);
      EXPECT_LT(klx(here), illuminance) << turbidity << " " << elevation;
      EXPECT_GT(chromaticity(radiance_to_xyz(here)).x, x) << turbidity << " " << elevation;
      EXPECT_LE(klx(here), klx(sun_irradiance(elevation, turbidity_range.low)));
      illuminance = klx(here);
      x = chromaticity(radiance_to_xyz(here)).x;
    }
  }
  EXPECT_NEAR(klx(sun_irradiance(90, 2)), 105, 8);  // the clear noon of the tropics
}

// Each absorber is there where its bands are.
TEST(Sunlight, GasesAbsorbInTheirBands) {
  EXPECT_LT(air_transmittance(600, 1, 2).ozone, 0.97);  // Chappuis
  EXPECT_GT(air_transmittance(400, 1, 2).ozone, 0.999);
  EXPECT_LT(air_transmittance(762, 1, 2).mixed_gases, 0.75);  // oxygen's A band
  EXPECT_EQ(air_transmittance(550, 1, 2).mixed_gases, 1);
  EXPECT_LT(air_transmittance(724, 1, 2).water_vapour, 0.9);
  EXPECT_EQ(air_transmittance(500, 1, 2).water_vapour, 1);
  EXPECT_NEAR(std::log(air_transmittance(500, 3, 4).aerosol), -3 * (0.04608 * 4 - 0.04586) * std::pow(0.5, -1.3),
              1e-12);
}

TEST(Daylight, ComponentsAddUpToDaylight) {
  const auto [s0, s1, s2] = daylight_components();
  const Xy d = daylight_chromaticity(5600);
  const double divisor = 0.0241 + 0.2562 * d.x - 0.7341 * d.y;
  const double m1 = (-1.3515 - 1.7703 * d.x + 5.9114 * d.y) / divisor,
               m2 = (0.0300 - 31.4424 * d.x + 30.0717 * d.y) / divisor;
  const Spectrum power = daylight_power(5600);
  for (std::size_t i = 0; i < power.size(); ++i) EXPECT_NEAR(s0[i] + m1 * s1[i] + m2 * s2[i], power[i], 1e-11);
}

}  // namespace
}  // namespace shabon::color
