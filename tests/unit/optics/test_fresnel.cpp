#include "shabon/optics/reference/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;

TEST(ForwardRoot, TravelsOrDecays) {
  EXPECT_EQ(forward_root(4), Complex(2, 0));
  EXPECT_EQ(forward_root(-4), Complex(0, 2));
  EXPECT_EQ(forward_root(Complex(-4, -0.0)), Complex(0, 2));
  EXPECT_EQ(forward_root(0), 0.0);
  EXPECT_GT(forward_root(Complex(-4, 1e-9)).imag(), 0);
  EXPECT_GT(forward_root(Complex(4, -1e-9)).real(), 0);
  EXPECT_GT(forward_root(Complex(-4, -1e-9)).imag(), 0);
}

TEST(NormalIndex, FollowsSnell) {
  const Incidence incidence = incidence_from(Degrees(40));
  EXPECT_NEAR(refracted_cosine(1, incidence, 1.5).real(), std::sqrt(1 - std::pow(incidence.sin_i / 1.5, 2)), 1e-15);
  for (double angle_deg = 0; angle_deg <= 90; ++angle_deg)
    for (const Complex same : {Complex(1.4), Complex(1.3, 0.2)}) {
      const Incidence at = incidence_from(Degrees(angle_deg));
      EXPECT_EQ(normal_index(same, at, same), same * at.cos_i);
      EXPECT_EQ(refracted_cosine(same, at, same), at.cos_i);
    }
  EXPECT_EQ(normal_index(1.5, incidence_from(Degrees(60)), 1).real(), 0);
  // An absorbing medium: n sin(theta) is carried over.
  const Complex n(0.2, 3.1), c = refracted_cosine(1, incidence, n);
  EXPECT_LT(std::abs(n * std::sqrt(1.0 - c * c) - incidence.sin_i), 1e-15);
}

TEST(Fresnel, GlassAtNormalIncidence) {
  const InterfaceAmplitudes wall = fresnel(1, 1, 1.5, 1);
  EXPECT_NEAR(wall.r_s.real(), -0.2, 1e-16);
  EXPECT_NEAR(wall.r_p.real(), 0.2, 1e-16);
  EXPECT_NEAR(wall.t_s.real(), 0.8, 1e-16);
  EXPECT_NEAR(wall.t_p.real(), 0.8, 1e-16);
}

TEST(Fresnel, EqualMediaAtGrazingIncidence) {
  const InterfaceAmplitudes wall = fresnel(1.3, 0, 1.3, 0);
  EXPECT_EQ(wall.r_s, 0.0);
  EXPECT_EQ(wall.t_p, 1.0);
}

// Neither a small index at normal incidence nor a nearly equal one at grazing incidence loses digits.
TEST(Fresnel, TheNormalIndexKeepsItsDigits) {
  EXPECT_EQ(normal_index(1.5, {}, 1e-3), 1e-3);
  EXPECT_EQ(normal_index(1.5, {}, std::complex<double>(1e-3, 2e-3)), std::complex<double>(1e-3, 2e-3));
  for (double cos_i : {1e-3, 1e-6, 1e-9}) {
    const double n = 1 + 0x1p-40, expected = std::hypot(std::sqrt(0x1p-40 * (n + 1)), cos_i);
    EXPECT_NEAR(normal_index(1, incidence_from_cos(cos_i), n).real() / expected, 1, 1e-15) << cos_i;
  }
}

}  // namespace
}  // namespace shabon::optics
