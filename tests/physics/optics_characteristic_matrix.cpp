// The Airy film against an independent derivation: the characteristic matrix (Born and Wolf, Principles of Optics,
// section 1.6; Macleod, Thin-Film Optical Filters, section 2.4), which knows tangential fields instead of beams.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/optics/reference/airy.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;

struct Answer {
  Complex r, t;  // of tangential electric fields
};

Answer characteristic_matrix(Complex eta1, Complex eta2, Complex eta3, Complex beta) {
  const Complex i(0, 1);
  const Complex electric = std::cos(beta) - i * std::sin(beta) / eta2 * eta3;  // of (1, eta3) carried to the first wall
  const Complex magnetic = -i * eta2 * std::sin(beta) + std::cos(beta) * eta3;
  return {(eta1 * electric - magnetic) / (eta1 * electric + magnetic), 2.0 * eta1 / (eta1 * electric + magnetic)};
}

Complex cosine(Complex n1, double sin_i, Complex n) {
  const Complex sine = n1 * sin_i / n;
  const Complex c = std::sqrt(1.0 - sine * sine);
  return (n * c).real() + (n * c).imag() < 0 ? -c : c;
}

TEST(CharacteristicMatrix, AgreesWithAiry) {
  Pcg32 random(6);
  for (int i = 0; i < 5000; ++i) {
    const Complex n1(random.uniform(1, 2), i % 4 == 0 ? random.uniform(0, 0.5) : 0);
    const auto index = [&] {
      const double n = random.uniform(0.3, 3);
      return Complex(n, random.uniform() < 0.5 ? 0 : random.uniform(0, 2));
    };
    const Complex n2 = index(), n3 = index();
    const double angle_deg = random.uniform(0, 85), d_nm = random.uniform(0, 800), lambda_nm = random.uniform(360, 830);
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    const Complex c1 = incidence.cos_i;
    const Complex c2 = cosine(n1, incidence.sin_i, n2), c3 = cosine(n1, incidence.sin_i, n3);
    const Complex beta = 2 * std::numbers::pi * n2 * c2 * d_nm / lambda_nm;
    const Answer s = characteristic_matrix(n1 * c1, n2 * c2, n3 * c3, beta);
    const Answer p = characteristic_matrix(n1 / c1, n2 / c2, n3 / c3, beta);
    const Amplitudes film = airy_amplitudes(n1, n2, n3, d_nm, incidence, lambda_nm);
    const double scale = 1e-11 * (1 + std::abs(p.t) + std::abs(c1 / c3));
    EXPECT_LT(std::abs(film.r_s - s.r), scale) << n1 << n2 << n3 << " " << angle_deg << " " << d_nm;
    EXPECT_LT(std::abs(film.t_s - s.t), scale) << n1 << n2 << n3 << " " << angle_deg << " " << d_nm;
    EXPECT_LT(std::abs(film.r_p + p.r), scale) << n1 << n2 << n3 << " " << angle_deg << " " << d_nm;
    EXPECT_LT(std::abs(film.t_p - p.t * c1 / c3), scale) << n1 << n2 << n3 << " " << angle_deg << " " << d_nm;
  }
}

}  // namespace
}  // namespace shabon::optics
