// Facts about the free film that follow from rho = r12^2 alone, in all three models.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {
namespace {

constexpr double n = 4.0 / 3, lambda_nm = 550;
constexpr double angles_deg[] = {0, 30, 53, 60, 75, 80, 85, 89};

struct Wall {
  double rho_s, rho_p;
  double half_wave_nm;  // the thickness that adds one cycle
};

Wall wall(Incidence incidence) {
  const auto r = fresnel(1, incidence.cos_i, n, refracted_cosine(1, incidence, n));
  return {norm(r.r_s), norm(r.r_p), lambda_nm / (2 * normal_index(1, incidence, n).real())};
}

TEST(TwoBeam, ZeroThicknessReflectsRhoCubed) {
  for (double angle_deg : angles_deg) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    const Powers beams = two_beam(1, n, 1, 0, incidence, lambda_nm);
    EXPECT_NEAR(beams.R_s, std::pow(wall(incidence).rho_s, 3), 1e-14);
    EXPECT_NEAR(beams.R_p, std::pow(wall(incidence).rho_p, 3), 1e-14);
  }
  EXPECT_NEAR(two_beam(1, n, 1, 0, {}, lambda_nm).R_s, 8.5e-6, 5e-8);
}

TEST(TwoBeam, MaximumIsRhoTimesTwoMinusRhoSquared) {
  for (double angle_deg : angles_deg) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    const Wall at = wall(incidence);
    const Powers beams = two_beam(1, n, 1, at.half_wave_nm / 2, incidence, lambda_nm);
    EXPECT_NEAR(beams.R_s, at.rho_s * std::pow(2 - at.rho_s, 2), 1e-13);
    EXPECT_NEAR(beams.R_p, at.rho_p * std::pow(2 - at.rho_p, 2), 1e-13);
    EXPECT_NEAR(beams.T_s, std::pow(1 - at.rho_s, 2), 1e-13);
    EXPECT_NEAR(beams.T_p, std::pow(1 - at.rho_p, 2), 1e-13);
  }
}

// Where the brightest reflection exceeds 1: beyond 77.6 degrees for s, 83.2 for p.
TEST(TwoBeam, ExceedsOneNearGrazing) {
  const auto brightest = [](double angle_deg) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    return two_beam(1, n, 1, wall(incidence).half_wave_nm / 2, incidence, lambda_nm);
  };
  EXPECT_LT(brightest(77.5).R_s, 1);
  EXPECT_GT(brightest(77.7).R_s, 1);
  EXPECT_LT(brightest(83.1).R_p, 1);
  EXPECT_GT(brightest(83.3).R_p, 1);
  const WallAverages clamped = wall_averages(brightest(89));
  EXPECT_EQ(clamped.f_h, 1);
  const Powers bright = brightest(80);
  EXPECT_EQ(wall_averages(bright).f_h, (1 + bright.R_p) / 2);
  EXPECT_EQ(wall_averages(bright).f_t, (bright.T_s + bright.T_p) / 2);
}

// Means over the phase: 1 - rho^2 + rho^3 for R2 + T2; 2 rho/(1 + rho), the film without interference, for Airy.
TEST(TwoBeam, MeansOverPhase) {
  constexpr int phases = 4096;
  for (double angle_deg : angles_deg) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    const Wall at = wall(incidence);
    double sum_s = 0, sum_p = 0, exact_s = 0, exact_p = 0;
    for (int i = 0; i < phases; ++i) {
      const double d_nm = at.half_wave_nm * i / phases;
      const Powers beams = two_beam(1, n, 1, d_nm, incidence, lambda_nm);
      sum_s += (beams.R_s + beams.T_s) / phases;
      sum_p += (beams.R_p + beams.T_p) / phases;
      const Powers exact = airy(1, n, 1, d_nm, incidence, lambda_nm);
      exact_s += exact.R_s / phases;
      exact_p += exact.R_p / phases;
    }
    EXPECT_NEAR(sum_s, 1 - std::pow(at.rho_s, 2) + std::pow(at.rho_s, 3), 1e-12);
    EXPECT_NEAR(sum_p, 1 - std::pow(at.rho_p, 2) + std::pow(at.rho_p, 3), 1e-12);
    const Powers none = without_interference(1, n, 1, 400, incidence, lambda_nm);
    EXPECT_NEAR(none.R_s, 2 * at.rho_s / (1 + at.rho_s), 1e-14);
    EXPECT_NEAR(none.T_s, 1 - none.R_s, 1e-14);
    EXPECT_NEAR(none.R_s, exact_s, 1e-12);
    EXPECT_NEAR(none.R_p, exact_p, 1e-12);
    EXPECT_NEAR(none.T_p, 1 - exact_p, 1e-12);
  }
}

// (10): R = F/(1 + F), F = 4 rho sin^2(delta/2)/(1 - rho)^2, delta = 4 pi n d cos(theta2)/lambda.
TEST(Airy, FreeFilmInRealForm) {
  for (double angle_deg : {0.0, 30.0, 53.0, 60.0, 75.0, 80.0})
    for (double d_nm = 0; d_nm < 2000; d_nm += 37) {
      const Incidence incidence = incidence_from(Degrees(angle_deg));
      const Wall at = wall(incidence);
      const double sine = std::sin(std::numbers::pi * d_nm / at.half_wave_nm);
      const auto expected = [&](double rho) {
        const double F = 4 * rho * sine * sine / ((1 - rho) * (1 - rho));
        return F / (1 + F);
      };
      const Powers film = airy(1, n, 1, d_nm, incidence, lambda_nm);
      EXPECT_NEAR(film.R_s, expected(at.rho_s), 1e-12);
      EXPECT_NEAR(film.R_p, expected(at.rho_p), 1e-12);
      EXPECT_NEAR(film.T_p, 1 - expected(at.rho_p), 1e-12);
    }
}

// Between different media, the start of the exact series: the next reflected beam is r12 r23^2, the next transmitted
// one r12 r23 times the first.
TEST(TwoBeam, BetweenDifferentMediaIsTheStartOfTheSeries) {
  constexpr double n2 = 1.35, n3 = 1.4;
  const double r12 = (n2 - 1) / (n2 + 1), r23 = (n3 - n2) / (n3 + n2);
  for (double d_nm : {0.0, 50.0, 120.0, 300.0}) {
    const Powers beams = two_beam(1, n2, n3, d_nm, {}, lambda_nm), exact = airy(1, n2, n3, d_nm, {}, lambda_nm);
    EXPECT_NEAR(beams.R_s, exact.R_s, 2.1 * (r12 + r23) * r12 * r23 * r23);
    EXPECT_NEAR(beams.T_s, exact.T_s, 2.1 * r12 * r23);
  }
}

}  // namespace
}  // namespace shabon::optics
