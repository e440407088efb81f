#include "shabon/optics/reference/ellipsometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/optics/reference/stack.h"

namespace shabon::optics {
namespace {

Amplitudes bare(std::complex<double> n, double angle_deg) {
  return stack_amplitudes(ResolvedStack{1, {}, n}, incidence_from(Degrees(angle_deg)), 633);
}

TEST(Ellipsometry, NormalAndGrazing) {
  for (std::complex<double> n : {std::complex<double>(1.5), std::complex<double>(0.2, 3.4)}) {
    EXPECT_NEAR(ellipsometry(bare(n, 0)).psi_deg, 45, 1e-12);
    EXPECT_NEAR(ellipsometry(bare(n, 0)).delta_deg, 180, 1e-12);
    EXPECT_NEAR(ellipsometry(bare(n, 90)).psi_deg, 45, 1e-12);
    EXPECT_NEAR(ellipsometry(bare(n, 90)).delta_deg, 0, 1e-12);
  }
}

// Below and above Brewster's angle, 56.31 degrees.
TEST(Ellipsometry, GlassKnowsTwoDeltas) {
  EXPECT_EQ(ellipsometry(bare(1.5, 56)).delta_deg, 180);
  EXPECT_EQ(ellipsometry(bare(1.5, 57)).delta_deg, 0);
  EXPECT_NEAR(ellipsometry(bare(1.5, std::atan(1.5) * 180 / std::numbers::pi)).psi_deg, 0, 1e-12);
}

// A metal's Delta falls from 180 to 0, and is 90 at its principal angle: instruments report it positive.
TEST(Ellipsometry, MetalsLieBetween) {
  double before = 180;
  for (double angle_deg : {10.0, 40.0, 60.0, 70.0, 80.0, 89.0}) {
    const double delta_deg = ellipsometry(bare({0.2, 3.4}, angle_deg)).delta_deg;
    EXPECT_LT(delta_deg, before);
    EXPECT_GT(delta_deg, 0);
    before = delta_deg;
  }
}

// The index of a bare medium follows from psi and Delta (Azzam and Bashara 1977): n^2 = sin^2 a (1 + tan^2 a x^2) with
// x = (1 - rho)/(1 + rho), conjugate indices for the time factor e^(+iwt).
TEST(Ellipsometry, GivesTheIndexBack) {
  const std::complex<double> n(3.88, 0.02);
  const double angle_rad = 1.2;
  const Ellipsometry seen =
      ellipsometry(stack_amplitudes(ResolvedStack{1, {}, n}, incidence_from_cos(std::cos(angle_rad)), 633));
  const double radians = std::numbers::pi / 180;
  const std::complex<double> rho = std::polar(std::tan(seen.psi_deg * radians), seen.delta_deg * radians);
  const std::complex<double> x = (1.0 - rho) / (1.0 + rho);
  const double sine = std::sin(angle_rad), tangent = std::tan(angle_rad);
  EXPECT_LT(std::abs(std::sqrt(sine * sine * (1.0 + tangent * tangent * x * x)) - conj(n)), 1e-12);
}

TEST(Ellipsometry, NothingToCompare) {
  const Ellipsometry none = ellipsometry(bare(1, 30));
  EXPECT_EQ(none.psi_deg, 0);
  EXPECT_EQ(none.delta_deg, 0);
  EXPECT_NEAR(transmission_ellipsometry(bare(1, 30)).psi_deg, 45, 1e-12);
}

TEST(Phases, OfAGlassPlate) {
  const Phases front = phases(bare(1.5, 0));
  EXPECT_EQ(front.r_s_deg, 180);
  EXPECT_EQ(front.r_p_deg, 0);
  EXPECT_EQ(front.t_s_deg, 0);
  // A layer of the surrounding medium only delays: by 360 degrees times n d cos/lambda.
  const ResolvedStack air{1, {{1, 100}}, 1};
  EXPECT_NEAR(phases(stack_amplitudes(air, incidence_from(Degrees(60)), 500)).t_p_deg, 360 * 100 * 0.5 / 500, 1e-10);
}

}  // namespace
}  // namespace shabon::optics
