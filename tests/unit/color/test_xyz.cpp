#include <gtest/gtest.h>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"

namespace {

using namespace shabon::color;

Spectrum constant(double value) {
  Spectrum spectrum;
  spectrum.fill(value);
  return spectrum;
}

TEST(Xyz, PerfectReflectorHasUnitLuminance) {
  for (const Observer& observer : observers()) {
    for (const Illuminant& lamp : illuminants()) {
      SCOPED_TRACE(lamp.name);
      const Xyz white = reflectance_to_xyz(constant(1), lamp, observer);
      EXPECT_NEAR(white.y, 1, 1e-15);
      EXPECT_NEAR(white.x, white_point(lamp, observer).x, 1e-14);
      EXPECT_NEAR(white.z, white_point(lamp, observer).z, 1e-14);
      const Xyz direct = radiance_to_xyz(lamp_radiance(lamp, observer), observer);
      EXPECT_NEAR(direct.x, white.x, 1e-13);
      EXPECT_NEAR(direct.y, 1, 1e-13);
      EXPECT_NEAR(direct.z, white.z, 1e-13);
    }
  }
}

TEST(Xyz, IsLinear) {
  const Illuminant& lamp = *find_illuminant("A");
  const Xyz half = reflectance_to_xyz(constant(0.5), lamp), white = white_point(lamp);
  EXPECT_NEAR(half.x, 0.5 * white.x, 1e-14);
  EXPECT_NEAR(half.z, 0.5 * white.z, 1e-14);
  EXPECT_EQ(reflectance_to_xyz(constant(0), lamp), (Xyz{0, 0, 0}));
}

// Both ends count in full: a line at 360 or 830 nm weighs what the observer says there.
TEST(Xyz, EndsHaveFullWeight) {
  const Observer& eye = observer_1931();
  for (const std::size_t i : {std::size_t{0}, std::size_t{470}}) {
    Spectrum line = constant(0);
    line[i] = 2;
    EXPECT_EQ(radiance_to_xyz(line, eye), (Xyz{2 * eye.x[i], 2 * eye.y[i], 2 * eye.z[i]}));
  }
}

// CIE 15:2018 prints five decimals for D65 and A. The sums of the 1931 functions at 1 nm (106.8655, 106.8569, 106.8922)
// leave the equal-energy lamp 4.6e-5 from 1/3.
TEST(Xyz, LampsHaveTheirPublishedChromaticities) {
  const struct {
    const char* lamp;
    double x, y, tolerance;
  } published[] = {{"D65", 0.31272, 0.32903, 2e-5}, {"A", 0.44758, 0.40745, 2e-5}, {"E", 1.0 / 3, 1.0 / 3, 5e-5}};
  for (const auto& row : published) {
    const Xy xy = chromaticity(white_point(*find_illuminant(row.lamp)));
    EXPECT_NEAR(xy.x, row.x, row.tolerance) << row.lamp;
    EXPECT_NEAR(xy.y, row.y, row.tolerance) << row.lamp;
  }
}

TEST(Xyz, PerfectReflectorUnderTabulatedD65InSrgb) {
  const LinearRgb white = xyz_to_linear_srgb(white_point(*find_illuminant("D65")));
  EXPECT_NEAR(white.r, 1.00016, 0.5e-5);
  EXPECT_NEAR(white.g, 0.99998, 0.5e-5);
  EXPECT_NEAR(white.b, 0.99976, 0.5e-5);
}

TEST(Xyz, BlackHasNoChromaticity) {
  EXPECT_EQ(chromaticity({0, 0, 0}), (Xy{0, 0}));
  EXPECT_EQ(chromaticity({-1, 0, 0}), (Xy{0, 0}));
}

}  // namespace
