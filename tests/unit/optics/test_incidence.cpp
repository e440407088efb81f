#include "shabon/optics/incidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shabon::optics {
namespace {

TEST(Incidence, EndsAreExact) {
  EXPECT_EQ(incidence_from(Degrees(0)).cos_i, 1);
  EXPECT_EQ(incidence_from(Degrees(0)).sin_i, 0);
  EXPECT_EQ(incidence_from(Degrees(90)).cos_i, 0);
  EXPECT_EQ(incidence_from(Degrees(90)).sin_i, 1);
}

TEST(Incidence, NearGrazingKeepsItsDigits) {
  const double complement_deg = 90 - 89.9999;
  EXPECT_NEAR(incidence_from(Degrees(89.9999)).cos_i / (Radians(Degrees(complement_deg)).value), 1, 1e-11);
}

TEST(Incidence, FromACosine) {
  for (double angle_deg : {0.0, 10.0, 45.0, 80.0, 90.0}) {
    const Incidence by_angle = incidence_from(Degrees(angle_deg));
    EXPECT_NEAR(incidence_from_cos(by_angle.cos_i).sin_i, by_angle.sin_i, 1e-15);
  }
}

}  // namespace
}  // namespace shabon::optics
