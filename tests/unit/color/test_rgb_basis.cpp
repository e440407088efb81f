#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shabon/color/illuminant.h"
#include "shabon/color/rgb_basis.h"

namespace {

using namespace shabon::color;

const Illuminant& d65() { return *find_illuminant("D65"); }

TEST(RgbBasis, LiesInUnitRangeAndSumsToOne) {
  const RgbBasis& basis = rgb_basis();
  for (std::size_t i = 0; i < spectrum_size; ++i) {
    for (const double value : {basis.r[i], basis.g[i], basis.b[i]}) {
      EXPECT_GE(value, 0) << wavelength_nm(i);
      EXPECT_LE(value, 1) << wavelength_nm(i);
    }
    EXPECT_NEAR(basis.r[i] + basis.g[i] + basis.b[i], 1, 1e-15) << wavelength_nm(i);
  }
}

TEST(RgbBasis, HasTheColoursOfThePrimariesAtTheLampsWhite) {
  constexpr double exact = 1e-12;
  const LinearRgb white = xyz_to_linear_srgb(white_point(d65()));
  const RgbBasis& basis = rgb_basis();
  const struct {
    const Spectrum& spectrum;
    LinearRgb expected;
  } primaries[] = {{basis.r, {white.r, 0, 0}}, {basis.g, {0, white.g, 0}}, {basis.b, {0, 0, white.b}}};
  for (const auto& primary : primaries) {
    const LinearRgb colour = xyz_to_linear_srgb(reflectance_to_xyz(primary.spectrum, d65()));
    EXPECT_NEAR(colour.r, primary.expected.r, exact);
    EXPECT_NEAR(colour.g, primary.expected.g, exact);
    EXPECT_NEAR(colour.b, primary.expected.b, exact);
  }
}

TEST(RgbBasis, AllOfSrgbComesBack) {
  constexpr double tolerance = 3e-4;
  double worst = 0;
  constexpr int steps = 16;
  for (int r = 0; r <= steps; ++r) {
    for (int g = 0; g <= steps; ++g) {
      for (int b = 0; b <= steps; ++b) {
        const LinearRgb colour{r / double(steps), g / double(steps), b / double(steps)};
        const LinearRgb seen = xyz_to_linear_srgb(radiance_to_xyz(rgb_to_radiance(colour)));
        worst =
            std::max({worst, std::abs(seen.r - colour.r), std::abs(seen.g - colour.g), std::abs(seen.b - colour.b)});
      }
    }
  }
  EXPECT_LT(worst, tolerance);
  RecordProperty("worst_round_trip", std::to_string(worst));
}

TEST(RgbBasis, WhiteIsTheLampItself) {
  const Spectrum lamp = lamp_radiance(d65()), white = rgb_to_radiance({1, 1, 1});
  for (std::size_t i = 0; i < spectrum_size; ++i) EXPECT_NEAR(white[i], lamp[i], 1e-15 * lamp[i] + 1e-18);
  EXPECT_NEAR(radiance_to_xyz(white).y, 1, 1e-13);
}

TEST(RgbBasis, IsLinear) {
  const Spectrum once = rgb_to_radiance({0.25, 0.5, 0.125}), twice = rgb_to_radiance({0.5, 1, 0.25});
  for (std::size_t i = 0; i < spectrum_size; ++i) EXPECT_DOUBLE_EQ(2 * once[i], twice[i]);
}

// No spikes and no steps: between no two neighbours more than 0.03, no bend sharper than 0.003, and no more turning
// points than smooth bands need. (The step of a primary made of two blocks would be 1, its bend 2.)
TEST(RgbBasis, IsSmooth) {
  const RgbBasis& basis = rgb_basis();
  for (const Spectrum* spectrum : {&basis.r, &basis.g, &basis.b}) {
    int turns = 0;
    double direction = 0;
    for (std::size_t i = 1; i + 1 < spectrum_size; ++i) {
      const double before = (*spectrum)[i] - (*spectrum)[i - 1], after = (*spectrum)[i + 1] - (*spectrum)[i];
      EXPECT_LT(std::abs(after), 0.03) << wavelength_nm(i);
      EXPECT_LT(std::abs(after - before), 0.003) << wavelength_nm(i);
      constexpr double flat = 1e-5;
      if (std::abs(after) > flat && after * direction < 0) ++turns;
      if (std::abs(after) > flat) direction = after;
    }
    EXPECT_LE(turns, 3);
  }
}

}  // namespace
