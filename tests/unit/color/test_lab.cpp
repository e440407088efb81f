#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/color/illuminant.h"
#include "shabon/color/lab.h"

namespace {

using namespace shabon::color;

TEST(Lab, WhiteAndBlack) {
  for (const Illuminant& lamp : illuminants()) {
    const Xyz white = white_point(lamp);
    const Lab lab = xyz_to_lab(white, white);
    EXPECT_NEAR(lab.L, 100, 1e-13);
    EXPECT_NEAR(lab.a, 0, 1e-13);
    EXPECT_NEAR(lab.b, 0, 1e-13);
    EXPECT_NEAR(xyz_to_lab({0, 0, 0}, white).L, 0, 1e-14);
  }
}

TEST(Lab, LightnessFiftyIsTheKnownGrey) {
  // Exactly ((50 + 16)/116)^3 = 35937/195112.
  EXPECT_NEAR(xyz_to_lab({0, 35937.0 / 195112, 0}, {1, 1, 1}).L, 50, 1e-13);
  // Below 216/24389 lightness is a straight line of slope 24389/27.
  for (const double y : {0.005, 0.0088}) EXPECT_NEAR(xyz_to_lab({0, y, 0}, {1, 1, 1}).L, y * 24389 / 27, 1e-13) << y;
  for (const double y : {0.0089, 0.0095})
    EXPECT_NEAR(xyz_to_lab({0, y, 0}, {1, 1, 1}).L, 116 * std::cbrt(y) - 16, 1e-13);
}

TEST(Lab, ComesBack) {
  const Xyz white = white_point(*find_illuminant("D65"));
  for (double x = 0; x <= 1; x += 0.05) {
    for (double y = 0; y <= 1; y += 0.05) {
      for (const double z : {0.0, 0.001, 0.00885, 0.00886, 0.3, 1.2}) {
        const Xyz back = lab_to_xyz(xyz_to_lab({x, y, z}, white), white);
        EXPECT_NEAR(back.x, x, 1e-14);
        EXPECT_NEAR(back.y, y, 1e-14);
        EXPECT_NEAR(back.z, z, 1e-14);
      }
    }
  }
}

TEST(Lab, AxesPointTheRightWay) {
  const Xyz white{1, 1, 1};
  EXPECT_GT(xyz_to_lab({0.6, 0.5, 0.5}, white).a, 0);  // reddish
  EXPECT_GT(xyz_to_lab({0.5, 0.5, 0.4}, white).b, 0);  // yellowish
}

TEST(Ciede2000, IsZeroForEqualAndSymmetric) {
  for (const Lab& lab : {Lab{0, 0, 0}, Lab{50, 0, 0}, Lab{50, 20, -30}, Lab{100, 0.001, 0}}) {
    EXPECT_EQ(ciede2000(lab, lab), 0);
    const Lab other{40, -5, 60};
    EXPECT_DOUBLE_EQ(ciede2000(lab, other), ciede2000(other, lab));
  }
}

// Two greys differ by lightness alone: delta L / S_L.
TEST(Ciede2000, GreysDifferByWeightedLightness) {
  const double off = 10;  // of the mean lightness from 50
  const double s_l = 1 + 0.015 * off * off / std::sqrt(20 + off * off);
  EXPECT_NEAR(ciede2000({55, 0, 0}, {65, 0, 0}), 10 / s_l, 1e-13);
}

// Opposite hues sit on a branch; the distance may not depend on how atan2 rounds there.
TEST(Ciede2000, OppositeHuesTakeOneBranch) {
  for (int degrees = 1; degrees < 180; ++degrees) {
    const double a = 2.5 * std::cos(degrees * std::numbers::pi / 180),
                 b = 2.5 * std::sin(degrees * std::numbers::pi / 180);
    const double distance = ciede2000({50, a, b}, {50, -a, -b});
    EXPECT_DOUBLE_EQ(distance, ciede2000({50, -a, -b}, {50, a, b})) << degrees;
    constexpr double short_of = 1e-8;  // radians by which the second hue is turned back
    const Lab nearly_opposite{50, -a - short_of * b, -b + short_of * a};
    EXPECT_NEAR(distance, ciede2000({50, a, b}, nearly_opposite), 1e-6) << degrees;
  }
}

}  // namespace
