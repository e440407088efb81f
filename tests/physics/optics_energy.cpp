// Energy and reciprocity: what holds for every film, tried on random ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "shabon/base/random.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/no_interference.h"

namespace shabon::optics {
namespace {

constexpr int tries = 2000;

TEST(Energy, FreeLosslessFilmLosesNothing) {
  Pcg32 random(1);
  for (int i = 0; i < tries; ++i) {
    const double n = random.uniform(1.01, 3), d_nm = random.uniform(0, 5000), lambda_nm = random.uniform(360, 830);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const Powers film = airy(1, n, 1, d_nm, incidence, lambda_nm);
    EXPECT_NEAR(film.R_s + film.T_s, 1, 2e-15) << n << " " << d_nm << " " << incidence.cos_i;
    EXPECT_NEAR(film.R_p + film.T_p, 1, 2e-15) << n << " " << d_nm << " " << incidence.cos_i;
  }
}

TEST(Energy, FreeLosslessFilmLosesNothingTowardsGrazing) {
  for (double complement_deg = 1; complement_deg > 1e-13; complement_deg /= 3) {
    const Incidence incidence = incidence_from_cos(std::sin(Radians(Degrees(complement_deg)).value));
    const Powers film = airy(1, 4.0 / 3, 1, 400, incidence, 550);
    EXPECT_NEAR(film.R_s + film.T_s, 1, 2e-15) << complement_deg;
    EXPECT_NEAR(film.R_p + film.T_p, 1, 2e-15) << complement_deg;
  }
}

TEST(Energy, LosslessFilmBetweenLosslessMedia) {
  Pcg32 random(2);
  for (int i = 0; i < tries; ++i) {
    const double n1 = random.uniform(1, 2.5), n2 = random.uniform(1, 2.5), n3 = random.uniform(1, 2.5);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const double d_nm = random.uniform(0, 1500), lambda_nm = random.uniform(360, 830);
    for (const Powers& film :
         {airy(n1, n2, n3, d_nm, incidence, lambda_nm), without_interference(n1, n2, n3, d_nm, incidence, lambda_nm)}) {
      EXPECT_NEAR(film.R_s + film.T_s, 1, 1e-13) << n1 << " " << n2 << " " << n3 << " " << incidence.cos_i;
      EXPECT_NEAR(film.R_p + film.T_p, 1, 1e-13) << n1 << " " << n2 << " " << n3 << " " << incidence.cos_i;
    }
  }
}

TEST(Energy, AnAbsorbingFilmOnlyTakes) {
  Pcg32 random(3);
  for (int i = 0; i < tries; ++i) {
    const std::complex<double> n2(random.uniform(0.05, 4), random.uniform(0, 6)),
        n3(random.uniform(0.05, 4), random.uniform(0, 6));
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const double d_nm = std::pow(10, random.uniform(-2, 5));
    for (const Powers& film :
         {airy(1.2, n2, n3, d_nm, incidence, 550), without_interference(1.2, n2, n3, d_nm, incidence, 550)})
      for (const auto& [R, T] : {std::array{film.R_s, film.T_s}, std::array{film.R_p, film.T_p}}) {
        EXPECT_GE(R, 0);
        EXPECT_GE(T, 0);
        EXPECT_LE(R + T, 1 + 1e-14) << n2 << n3 << d_nm << " " << incidence.cos_i;
      }
  }
}

// The transmittance is the same from both sides, for absorbing films too; the reflectance only without absorption.
TEST(Reciprocity, TransmittanceFromBothSides) {
  Pcg32 random(4);
  for (int i = 0; i < tries; ++i) {
    const double n1 = random.uniform(1, 2), n3 = random.uniform(1, 2);
    const bool absorbs = i % 2 == 1;
    const std::complex<double> n2(random.uniform(0.1, 3), absorbs ? random.uniform(0, 3) : 0);
    const double d_nm = random.uniform(0, 600), lambda_nm = random.uniform(360, 830);
    const Incidence there = incidence_from(Degrees(random.uniform(0, 89)));
    const std::complex<double> c3 = refracted_cosine(n1, there, n3);
    if (c3.imag() != 0) continue;
    const Powers forward = airy(n1, n2, n3, d_nm, there, lambda_nm);
    const Powers back = airy(n3, n2, n1, d_nm, incidence_from_cos(c3.real()), lambda_nm);
    EXPECT_NEAR(forward.T_s, back.T_s, 1e-13);
    EXPECT_NEAR(forward.T_p, back.T_p, 1e-13);
    if (!absorbs) {
      EXPECT_NEAR(forward.R_s, back.R_s, 1e-13);
      EXPECT_NEAR(forward.R_p, back.R_p, 1e-13);
    }
  }
}

// Stokes' relations at one interface: r12 = -r21, t12 t21 = 1 - r12^2.
TEST(Reciprocity, StokesRelations) {
  Pcg32 random(5);
  for (int i = 0; i < tries; ++i) {
    const std::complex<double> n1(random.uniform(1, 2)), n2(random.uniform(0.1, 3), random.uniform(0, 3));
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const std::complex<double> c1 = incidence.cos_i, c2 = refracted_cosine(n1, incidence, n2);
    const InterfaceAmplitudes there = fresnel(n1, c1, n2, c2), back = fresnel(n2, c2, n1, c1);
    EXPECT_LT(std::abs(there.r_s + back.r_s), 1e-14);
    EXPECT_LT(std::abs(there.r_p + back.r_p), 1e-14);
    EXPECT_LT(std::abs(there.t_s * back.t_s - (1.0 - there.r_s * there.r_s)), 1e-14);
    EXPECT_LT(std::abs(there.t_p * back.t_p - (1.0 - there.r_p * there.r_p)), 1e-13);
  }
}

}  // namespace
}  // namespace shabon::optics
