// The sky against the formulas of its paper, written down once more here, and what they must mean as light.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/color/daylight.h"
#include "shabon/color/sunlight.h"
#include "shabon/color/xyz.h"
#include "shabon/math/packet.h"
#include "shabon/math/packet_math.h"
#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

using math::Vec3d;

constexpr double pi = std::numbers::pi;
constexpr double turbidities[] = {2, 2.5, 3, 5, 7, 10};
constexpr double elevations_deg[] = {0, 3, 10, 25, 40, 60, 75, 90};

Vec3d direction_of(double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * pi / 180, a = azimuth_deg * pi / 180;
  return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

std::vector<Vec3d> directions_above() {
  std::vector<Vec3d> result{{0, 1, 0}};
  for (const double elevation : {0.5, 2.0, 7.0, 20.0, 45.0, 70.0, 88.0})
    for (double azimuth = 0; azimuth < 360; azimuth += 23) result.push_back(direction_of(elevation, azimuth));
  return result;
}

// Preetham, Shirley, Smits 1999, equations 3 and 4 and appendix A.2; luminance in kcd/m^2.
struct Paper {
  double turbidity, sun_zenith;

  using Five = std::array<double, 5>;
  double perez(const Five& k, double zenith, double to_sun) const {
    return (1 + k[0] * std::exp(k[1] / std::cos(zenith))) *
           (1 + k[2] * std::exp(k[3] * to_sun) + k[4] * std::pow(std::cos(to_sun), 2));
  }
  double at(const Five& slope, const Five& offset, double at_zenith, double zenith, double to_sun) const {
    Five k;
    for (std::size_t i = 0; i < 5; ++i) k[i] = slope[i] * turbidity + offset[i];
    return at_zenith * perez(k, zenith, to_sun) / perez(k, 0, sun_zenith);
  }
  double zenith_luminance() const {
    const double chi = (4.0 / 9.0 - turbidity / 120.0) * (pi - 2 * sun_zenith);
    return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
  }
  double luminance(double zenith, double to_sun) const {
    return at({0.1787, -0.3554, -0.0227, 0.1206, -0.0670}, {-1.4630, 0.4275, 5.3251, -2.5771, 0.3703},
              zenith_luminance(), zenith, to_sun);
  }
  double x(double zenith, double to_sun) const {
    const double s = sun_zenith, s2 = s * s, s3 = s2 * s, t = turbidity;
    const double at_zenith = t * t * (0.00166 * s3 - 0.00375 * s2 + 0.00209 * s) +
                             t * (-0.02903 * s3 + 0.06377 * s2 - 0.03202 * s + 0.00394) +
                             (0.11693 * s3 - 0.21196 * s2 + 0.06052 * s + 0.25886);
    return at({-0.0193, -0.0665, -0.0004, -0.0641, -0.0033}, {-0.2592, 0.0008, 0.2125, -0.8989, 0.0452}, at_zenith,
              zenith, to_sun);
  }
  double y(double zenith, double to_sun) const {
    const double s = sun_zenith, s2 = s * s, s3 = s2 * s, t = turbidity;
    const double at_zenith = t * t * (0.00275 * s3 - 0.00610 * s2 + 0.00317 * s) +
                             t * (-0.04214 * s3 + 0.08970 * s2 - 0.04153 * s + 0.00516) +
                             (0.15346 * s3 - 0.26756 * s2 + 0.06670 * s + 0.26688);
    return at({-0.0167, -0.0950, -0.0079, -0.0441, -0.0109}, {-0.2608, 0.0092, 0.2102, -1.6537, 0.0529}, at_zenith,
              zenith, to_sun);
  }
};

color::Spectrum spectrum_of(const SkyAndSun& made, const Vec3d& direction) {
  std::vector<double> coefficients(made.channels.size());
  made.sky.add(direction, coefficients.data());
  color::Spectrum sum{};
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += coefficients[k] * made.channels[k][i];
  return sum;
}

double luminance(const SkyAndSun& made, const Vec3d& direction) {
  return color::radiance_to_xyz(spectrum_of(made, direction)).y;
}

double angle(const Vec3d& a, const Vec3d& b) { return std::acos(std::min(1.0, std::max(-1.0, math::dot(a, b)))); }

TEST(Sky, HasTheLuminanceAndTheColourOfThePaperEverywhere) {
  int moved = 0, all = 0;
  for (const double turbidity : turbidities)
    for (const double elevation : elevations_deg) {
      SCOPED_TRACE(testing::Message() << "turbidity " << turbidity << ", sun at " << elevation);
      const SkyAndSun made = sky_and_sun({elevation, 70, turbidity}, 0);
      const Paper paper{turbidity, (90 - elevation) * pi / 180};
      EXPECT_NEAR(luminance(made, {0, 1, 0}) * made.unit_cd_m2 / 1000 / paper.zenith_luminance(), 1, 1e-9);
      for (const Vec3d& direction : directions_above()) {
        const double zenith = angle(direction, {0, 1, 0}), to_sun = angle(direction, direction_of(elevation, 70));
        const color::Xyz xyz = color::radiance_to_xyz(spectrum_of(made, direction));
        EXPECT_NEAR(xyz.y * made.unit_cd_m2 / 1000 / paper.luminance(zenith, to_sun), 1, 1e-6);
        const color::Xy xy = color::chromaticity(xyz);
        const double dx = xy.x - paper.x(zenith, to_sun), dy = xy.y - paper.y(zenith, to_sun);
        const double off = std::hypot(dx, dy);
        // Around a low sun and in thick haze the paper has colours that no sum of the components without negative light
        // has.
        if (elevation >= 25 && turbidity <= 7)
          EXPECT_LT(off, 1e-7);
        else
          EXPECT_LT(off, elevation >= 10 ? 0.05 : 0.15);
        ++all;
        if (off > 1e-7) ++moved;
      }
    }
  EXPECT_LT(moved, all / 8) << all;
}

// CIE 15:2018, 4.9 and 4.10 give M1 and M2 of a chromaticity with rounded numbers: colours to some 1e-4.
TEST(Sky, AddsTheComponentsAsTheCieDoes) {
  const SkyAndSun made = sky_and_sun({40, 0, 3}, 0);
  const auto cie = color::daylight_components();
  for (const Vec3d& direction : directions_above()) {
    const auto sum = made.sky.components(direction);
    const color::Xy d = color::chromaticity(color::radiance_to_xyz(spectrum_of(made, direction)));
    const double divisor = 0.0241 + 0.2562 * d.x - 0.7341 * d.y;
    const double m1 = (-1.3515 - 1.7703 * d.x + 5.9114 * d.y) / divisor,
                 m2 = (0.0300 - 31.4424 * d.x + 30.0717 * d.y) / divisor;
    EXPECT_NEAR(sum[1] / sum[0], m1, 0.1);
    EXPECT_NEAR(sum[2] / sum[0], m2, 0.15);
    color::Spectrum theirs{};
    for (std::size_t i = 0; i < theirs.size(); ++i) theirs[i] = cie[0][i] + m1 * cie[1][i] + m2 * cie[2][i];
    const color::Xy xy = color::chromaticity(color::radiance_to_xyz(theirs));
    EXPECT_NEAR(xy.x, d.x, 5e-4);
    EXPECT_NEAR(xy.y, d.y, 5e-4);
  }
}

TEST(Sky, NoLightIsNegative) {
  for (const double turbidity : turbidities)
    for (const double elevation : elevations_deg) {
      const SkyAndSun made = sky_and_sun({elevation, 0, turbidity}, 0);
      for (const Vec3d& direction : directions_above()) {
        const color::Spectrum here = spectrum_of(made, direction);
        EXPECT_GT(*std::min_element(here.begin(), here.end()), 0) << turbidity << " " << elevation;
      }
    }
}

// Colours far from daylight: the sum keeps its luminance and stays positive.
TEST(Sky, MovesImpossibleColoursTowardsTheMeanDaylight) {
  SkyAndSun made = sky_and_sun({40, 0, 3}, 0);
  for (const double red : {0.5, 1.5, 2.0}) {
    SkyAndSun odd = made;
    odd.sky.x.factor *= red;
    for (const Vec3d& direction : directions_above()) {
      const color::Spectrum here = spectrum_of(odd, direction);
      EXPECT_GT(*std::min_element(here.begin(), here.end()), 0);
      EXPECT_NEAR(luminance(odd, direction) / luminance(made, direction), 1, 1e-9);
    }
  }
}

TEST(Sky, ManyDirectionsAtOnceAreTheSame) {
  using Many = math::packet<float, 16>;
  for (const double turbidity : turbidities) {
    const SkyAndSun made = sky_and_sun({25, 40, turbidity}, 0);
    std::vector<Vec3d> directions = directions_above();
    directions.push_back(made.sky.sun);
    for (double off = 1e-4; off < 0.1; off *= 3) directions.push_back(direction_of(25 + off * 180 / pi, 40));
    directions.push_back({0.6, -0.8, 0});
    for (const Vec3d& d : directions) {
      std::vector<double> one(4);
      std::vector<Many> many(4, Many(0.0f));
      made.sky.add(d, one.data());
      made.sky.add(
          math::Vec3<Many>{Many(static_cast<float>(d.x)), Many(static_cast<float>(d.y)), Many(static_cast<float>(d.z))},
          many.data());
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(many[k][5], one[k], 5e-5 * std::abs(one[0]) + 1e-6) << d.x << " " << d.y << " " << d.z << " " << k;
    }
  }
}

// The integral of the luminance times a cosine, over directions above; the sun's disk by its own solid angle.
struct Illuminance {
  double sky = 0, sun = 0;
};
Illuminance on_the_ground(const SkyAndSun& made) {
  Illuminance result;
  constexpr int rings = 90, steps = 180;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < steps; ++j) {
      const double zenith = (i + 0.5) * pi / 2 / rings;
      const Vec3d d = direction_of(90 - zenith * 180 / pi, (j + 0.5) * 360 / steps);
      result.sky += luminance(made, d) * std::cos(zenith) * std::sin(zenith) * (pi / 2 / rings) * (2 * pi / steps);
    }
  if (made.sun) result.sun = made.sun->scale * 2 * pi * (1 - made.sun->cos_half_angle) * made.sun->axis.y;
  return result;
}

TEST(Sky, AWhiteCardInTheOpenIsWhite) {
  for (const double elevation : {1.0, 30.0, 80.0}) {
    const SkyAndSun made = sky_and_sun({elevation, 10, 4}, 0);
    const Illuminance light = on_the_ground(made);
    EXPECT_NEAR((light.sky + light.sun) / pi, 1, 2e-3) << elevation;
    const Illuminance dim = on_the_ground(sky_and_sun({elevation, 10, 4, 0.25}, 0));
    EXPECT_NEAR(dim.sky, light.sky / 4, 1e-9);
    EXPECT_NEAR(dim.sun, light.sun / 4, 1e-9);
  }
}

// The sun's illuminance is that of a clear day. The paper's sky is on the bright side: 31 klx where one measures 10
// to 20.
TEST(Sky, SunAndSkyShareTheLightAsThePaperSays) {
  const SkyAndSun made = sky_and_sun({60, 0, 3}, 0);
  const Illuminance light = on_the_ground(made);
  EXPECT_NEAR(light.sun * made.unit_cd_m2 / 1000, 79, 2);
  EXPECT_NEAR(light.sky * made.unit_cd_m2 / 1000, 31.5, 1);
  EXPECT_NEAR(light.sun / light.sky, 2.5, 0.1);
  // Haze takes from the sun and gives to the sky; a low sun is weak.
  const Illuminance hazy = on_the_ground(sky_and_sun({60, 0, 8}, 0)), low = on_the_ground(sky_and_sun({5, 0, 3}, 0));
  EXPECT_LT(hazy.sun / hazy.sky, light.sun / light.sky / 2);
  EXPECT_LT(low.sun / low.sky, 1);
}

TEST(Sky, TheSunStandsWhereItIsSaidAndHasItsSpectrum) {
  const SkyAndSun made = sky_and_sun({30, 90, 3}, 7);
  ASSERT_TRUE(made.sun);
  EXPECT_NEAR(math::length(made.sun->axis - Vec3d{std::sqrt(0.75), 0.5, 0}), 0, 1e-12);  // azimuth 90: towards +x
  EXPECT_EQ(made.sky.first_channel, 7);
  EXPECT_EQ(made.sun->channel, 10);
  ASSERT_EQ(made.channels.size(), 4u);
  EXPECT_NEAR(color::radiance_to_xyz(made.channels[3]).y, 1, 1e-12);
  EXPECT_NEAR(color::radiance_to_xyz(made.channels[0]).y, 1, 1e-12);
  const color::Spectrum direct = color::sun_irradiance(30, 3);
  for (const std::size_t i : {0u, 100u, 300u, 470u})
    EXPECT_NEAR(made.channels[3][i] / made.channels[3][190], direct[i] / direct[190], 1e-12);
  for (const auto& [off_deg, inside] : {std::pair{0.0, true}, {0.26, true}, {0.27, false}}) {
    double amount[11] = {};
    made.sun->add(direction_of(30 + off_deg, 90), amount);
    EXPECT_EQ(amount[10] > 0, inside) << off_deg;
  }
}

// In float the disk keeps its size: the rim of 4.65 mrad stands to 1e-4 of it.
TEST(Sky, TheRimOfTheSunIsSharpInFloat) {
  using Many = math::packet<float, 16>;
  const SkyAndSun made = sky_and_sun({30, 20, 3}, 0);
  for (double azimuth = 0; azimuth < 6; azimuth += 0.37)
    for (const double share : {0.9985, 1.0015}) {
      const Vec3d right = math::normalize(math::cross(made.sky.sun, Vec3d{0, 1, 0}));
      const Vec3d up = math::cross(right, made.sky.sun);
      const double off = share * color::sun_half_angle_deg * pi / 180;
      const Vec3d d =
          made.sky.sun * std::cos(off) + (right * std::cos(azimuth) + up * std::sin(azimuth)) * std::sin(off);
      std::vector<Many> many(4, Many(0.0f));
      made.sun->add(
          math::Vec3<Many>{Many(static_cast<float>(d.x)), Many(static_cast<float>(d.y)), Many(static_cast<float>(d.z))},
          many.data());
      EXPECT_EQ(many[3][3] > 0, share < 1) << azimuth << " " << share;
    }
}

TEST(Sky, TheGroundIsGreyAndLit) {
  const SkyAndSun made = sky_and_sun({50, 0, 3, 1, true, 0.3}, 0), shaded = sky_and_sun({50, 0, 3, 1, false, 0.3}, 0);
  EXPECT_NEAR(luminance(made, {0, -1, 0}), 0.3, 1e-9);
  EXPECT_EQ(luminance(made, direction_of(-1, 100)), luminance(made, {0, -1, 0}));
  EXPECT_EQ(luminance(sky_and_sun({50, 0, 3, 1, true, 0}, 0), {0, -1, 0}), 0);
  // Without the sun's disk the sky stays, and the ground has the sky's light alone.
  ASSERT_FALSE(shaded.sun);
  EXPECT_EQ(shaded.channels.size(), 3u);
  EXPECT_EQ(luminance(shaded, {0, 1, 0}), luminance(made, {0, 1, 0}));
  EXPECT_NEAR(luminance(shaded, {0, -1, 0}), 0.3 * on_the_ground(shaded).sky / pi, 1e-3);
}

TEST(Sky, StandsInAScene) {
  SceneDesc description;
  SoftboxDesc softbox;
  softbox.direction = {0, 0, 1};
  description.environment.softboxes = {softbox};
  description.environment.base = SkyEnvironmentDesc{30, 0, 4};
  const Result<Scene> scene = compile(description, {});
  ASSERT_TRUE(scene) << to_text(scene.errors());
  ASSERT_TRUE(std::holds_alternative<SkyLight>(scene->environment.base));
  EXPECT_EQ(scene->environment.softboxes.size(), 2u);
  EXPECT_EQ(scene->environment.channels.size(), 5u);
  std::get<SkyEnvironmentDesc>(description.environment.base).sun = false;
  EXPECT_EQ(compile(description, {})->environment.softboxes.size(), 1u);
  description.environment.base = SkyEnvironmentDesc{-0.5, 0, 1.9};
  const Result<Scene> night = compile(description, {});
  ASSERT_FALSE(night);
  EXPECT_EQ(to_text(night.errors()),
            "error: environment.sky.sun_elevation_deg: expected >= 0 degrees, got -0.5\n"
            "error: environment.sky.turbidity: expected >= 2, got 1.9\n");
}

}  // namespace
}  // namespace shabon::scene
