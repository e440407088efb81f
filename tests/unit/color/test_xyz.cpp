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

// Every observer sees the equal-energy lamp near (1/3, 1/3): the sums of the colour-matching functions at 1 nm agree to
// about 4e-4 (106.8655, 106.8569, 106.8922 for 1931).
TEST(Xyz, EqualEnergyIsNearlyGreyToEveryObserver) {
  for (const Observer& observer : observers()) {
    const Xy xy = chromaticity(white_point(*find_illuminant("E"), observer));
    EXPECT_NEAR(xy.x, 1.0 / 3, 5e-5) << observer.name;
    EXPECT_NEAR(xy.y, 1.0 / 3, 5e-5) << observer.name;
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
