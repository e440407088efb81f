// Films whose answer is known without a calculation, and limits that must not be special spots.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;
constexpr double lambda_nm = 550;

TEST(Limits, BrewsterFilmReflectsNoP) {
  for (double n : {1.2, 4.0 / 3, 1.5, 2.4}) {
    const Incidence brewster = incidence_from_cos(1 / std::sqrt(1 + n * n));
    for (double d_nm : {0.0, 100.0, 333.0, 5000.0}) {
      EXPECT_LT(airy(1, n, 1, d_nm, brewster, lambda_nm).R_p, 1e-30);
      EXPECT_LT(two_beam(1, n, 1, d_nm, brewster, lambda_nm).R_p, 1e-30);
      EXPECT_LT(without_interference(1, n, 1, d_nm, brewster, lambda_nm).R_p, 1e-30);
    }
  }
}

// A quarter wave of sqrt(n1 n3) reflects nothing; of any n it gives ((n1 n3 - n^2)/(n1 n3 + n^2))^2.
TEST(Limits, QuarterWave) {
  const double n3 = 1.52, matched = std::sqrt(n3);
  EXPECT_LT(airy(1, matched, n3, lambda_nm / (4 * matched), {}, lambda_nm).R_s, 1e-30);
  for (double n : {1.38, 2.0, 2.4})
    for (int odd : {1, 3, 101}) {
      const double expected = std::pow((n3 - n * n) / (n3 + n * n), 2);
      EXPECT_NEAR(airy(1, n, n3, odd * lambda_nm / (4 * n), {}, lambda_nm).R_p, expected, 1e-13);
    }
}

// A half wave is absent.
TEST(Limits, HalfWave) {
  const Complex n3(0.2, 3.4);
  for (double angle_deg : {0.0, 30.0, 80.0})
    for (int waves : {1, 2, 1000}) {
      const Incidence incidence = incidence_from(Degrees(angle_deg));
      const double n2_c2 = normal_index(1, incidence, 1.7).real();
      const Powers film = airy(1, 1.7, n3, waves * lambda_nm / (2 * n2_c2), incidence, lambda_nm);
      const Powers bare = airy(1, n3, n3, 0, incidence, lambda_nm);
      EXPECT_NEAR(film.R_s, bare.R_s, 1e-11);
      EXPECT_NEAR(film.T_p, bare.T_p, 1e-11);
    }
}

// No thickness, or a film of either neighbour's medium: the bare interface of fresnel().
TEST(Limits, NoFilmIsTheInterface) {
  for (Complex n3 : {Complex(1.52), Complex(0.2, 3.4), Complex(0.7)})
    for (double angle_deg : {0.0, 44.0, 60.0, 89.999}) {
      const Incidence incidence = incidence_from(Degrees(angle_deg));
      const InterfaceAmplitudes bare = fresnel(1.1, incidence.cos_i, n3, refracted_cosine(1.1, incidence, n3));
      const auto none = airy_amplitudes(1.1, Complex(1.8, 0.1), n3, 0, incidence, lambda_nm);
      const auto same_exit = airy_amplitudes(1.1, n3, n3, 0, incidence, lambda_nm);
      for (const Amplitudes& film : {none, same_exit}) {
        EXPECT_LT(std::abs(film.r_s - bare.r_s), 1e-14);
        EXPECT_LT(std::abs(film.r_p - bare.r_p), 1e-14);
        EXPECT_LT(std::abs(film.t_s - bare.t_s), 1e-14);
        EXPECT_LT(std::abs(film.t_p - bare.t_p), 1e-14);
      }
      const auto same_front = airy(1.1, 1.1, n3, 12345, incidence, lambda_nm);
      EXPECT_NEAR(same_front.R_p, norm(bare.r_p), 1e-14);
    }
}

TEST(Limits, EqualMediaAreInvisible) {
  for (double angle_deg : {0.0, 60.0, 89.9999999, 90.0}) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    for (const Powers& film :
         {airy(1.33, 1.33, 1.33, 700, incidence, lambda_nm), airy(1.33, 2, 1.33, 0, incidence, lambda_nm),
          two_beam(1.33, 1.33, 1.33, 700, incidence, lambda_nm),
          without_interference(1.33, 1.33, 1.33, 700, incidence, lambda_nm)}) {
      EXPECT_NEAR(film.R_s, 0, 1e-30) << angle_deg;
      EXPECT_NEAR(film.R_p, 0, 1e-30) << angle_deg;
      EXPECT_NEAR(film.T_s, 1, 1e-14) << angle_deg;
      EXPECT_NEAR(film.T_p, 1, 1e-14) << angle_deg;
    }
  }
}

TEST(Limits, NormalIncidenceKnowsNoPolarisation) {
  const Amplitudes film = airy_amplitudes(1, Complex(1.6, 0.2), Complex(3, 1), 90, {}, lambda_nm);
  EXPECT_LT(std::abs(film.r_s + film.r_p), 1e-15);
  EXPECT_LT(std::abs(film.t_s - film.t_p), 1e-15);
}

// At 90 degrees everything is reflected, and the way there is smooth.
TEST(Limits, GrazingIncidence) {
  for (Complex n2 : {Complex(1.33), Complex(0.8), Complex(0.2, 3)})
    for (Complex n3 : {Complex(1), Complex(1.5), Complex(4, 0.1)}) {
      const Incidence along = incidence_from(Degrees(90)), nearly = incidence_from_cos(1e-12);
      for (auto* model : {airy, two_beam, without_interference}) {
        const Powers film = model(1, n2, n3, 130, along, lambda_nm), before = model(1, n2, n3, 130, nearly, lambda_nm);
        for (double R : {film.R_s, film.R_p}) EXPECT_EQ(R, 1);
        for (double T : {film.T_s, film.T_p}) EXPECT_EQ(T, 0);
        for (double R : {before.R_s, before.R_p}) EXPECT_NEAR(R, 1, 1e-9);
        for (double T : {before.T_s, before.T_p}) EXPECT_NEAR(T, 0, 1e-9);
      }
      const Amplitudes amplitudes = airy_amplitudes(1, n2, n3, 130, along, lambda_nm);
      EXPECT_EQ(amplitudes.r_s, -1.0);
      EXPECT_EQ(amplitudes.r_p, -1.0);
    }
}

TEST(Limits, TotalReflection) {
  const Powers film = airy(1.5, 1.38, 1, 100, incidence_from(Degrees(50)), lambda_nm);
  EXPECT_NEAR(film.R_s, 1, 1e-14);
  EXPECT_NEAR(film.R_p, 1, 1e-14);
  EXPECT_EQ(film.T_s, 0);
  EXPECT_EQ(film.T_p, 0);
  EXPECT_FALSE(std::signbit(film.T_p));
}

// Frustrated total reflection: T falls with the gap from 1 to 0, for a wide gap as e^(-4 pi d |n2 c2|/lambda).
TEST(Limits, FrustratedTotalReflection) {
  const Incidence incidence = incidence_from(Degrees(60));
  const double decay_per_nm = 4 * std::numbers::pi * normal_index(1.5, incidence, 1).imag() / lambda_nm;
  double previous = 1 + 1e-15;
  for (double gap_nm = 0; gap_nm <= 2000; gap_nm += 50) {
    const Powers film = airy(1.5, 1, 1.5, gap_nm, incidence, lambda_nm);
    EXPECT_LT(film.T_s, previous);
    EXPECT_NEAR(film.R_s + film.T_s, 1, 1e-14);
    if (gap_nm > 1500) {
      EXPECT_NEAR(film.T_s / previous, std::exp(-decay_per_nm * 50), 1e-3);
    }
    previous = film.T_s;
  }
}

// At the critical angle of the film, where n2 c2 = 0, the answer joins its neighbours.
TEST(Limits, CriticalAngleOfTheFilmIsNoSpecialSpot) {
  const Incidence critical = {0.6, 0.8};  // sin = 1/1.25
  ASSERT_EQ(normal_index(1.25, critical, 1), 0.0);
  const Powers at = airy(1.25, 1, 1.25, 80, critical, lambda_nm);
  for (double step : {-1e-9, 1e-9}) {
    const Powers beside = airy(1.25, 1, 1.25, 80, incidence_from_cos(0.6 + step), lambda_nm);
    EXPECT_NEAR(at.R_s, beside.R_s, 1e-7);
    EXPECT_NEAR(at.T_s, beside.T_s, 1e-7);
    EXPECT_NEAR(at.R_p, beside.R_p, 1e-7);
    EXPECT_NEAR(at.T_p, beside.T_p, 1e-7);
  }
  EXPECT_GT(at.R_s, 0.1);
}

// An opaque film hides what lies behind it, and nothing overflows.
TEST(Limits, OpaqueFilm) {
  const Complex metal(0.9, 6.5);
  for (double d_nm : {1e4, 1e6, 1e9}) {
    const Powers film = airy(1, metal, 1.5, d_nm, incidence_from(Degrees(30)), lambda_nm);
    const Powers bulk = airy(1, metal, metal, 0, incidence_from(Degrees(30)), lambda_nm);
    EXPECT_NEAR(film.R_s, bulk.R_s, 1e-15);
    EXPECT_NEAR(film.R_p, bulk.R_p, 1e-15);
    EXPECT_LT(film.T_s, 1e-300);
  }
  // Light from inside an absorbing medium meets a wave that would grow in the film: the answers stay finite.
  for (auto* model : {airy, two_beam, without_interference}) {
    const Powers inside = model(Complex(1.5, 0.1), 1.5, 1, 1e6, incidence_from(Degrees(30)), lambda_nm);
    for (double power : {inside.R_s, inside.R_p, inside.T_s, inside.T_p}) EXPECT_TRUE(std::isfinite(power));
  }
}

// Two and a half million exact waves of film are a half wave: thickness costs the phase no digits.
TEST(Limits, ThickFilmsKeepTheirPhase) {
  const double thick_nm = 1e9;  // n d/lambda = 1.25 1e9/500
  EXPECT_LT(std::abs(airy_amplitudes(1, 1.25, 1, thick_nm, {}, 500).r_s), 1e-14);
  EXPECT_LT(std::abs(airy_amplitudes(1, 1.25, 1.5, thick_nm, {}, 500).r_s - Complex(-0.2)), 1e-14);
}

// A metal film under total reflection, where the wall's reflected amplitude exceeds 1: sums without phase mean nothing
// there, and are held.
TEST(Limits, WithoutInterferenceIsHeldWhereItMeansNothing) {
  for (double d_nm = 0; d_nm < 100; d_nm += 0.5) {
    const Powers film = without_interference(1.517, Complex(0.13, 3.16), 1, d_nm, incidence_from(Degrees(44)), 633);
    EXPECT_GE(film.R_p, 0.9) << d_nm;
    EXPECT_LE(film.R_p, 1) << d_nm;
    if (d_nm <= 20) {
      EXPECT_EQ(film.R_p, 1) << d_nm;
    }
  }
  const Powers total = without_interference(1.5, 1, 1.5, 100, incidence_from(Degrees(60)), lambda_nm);
  EXPECT_NEAR(total.R_s, 1, 1e-15);
  EXPECT_NEAR(total.T_p, 0, 1e-15);
}

}  // namespace
}  // namespace shabon::optics
