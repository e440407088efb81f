#include "shabon/math/packet_complex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "shabon/base/random.h"

namespace shabon::math {
namespace {

constexpr int lanes = 8;
using P = packet<double, lanes>;
using C = complex_packet<double, lanes>;
using Exact = std::complex<long double>;

C packed(const std::complex<double> (&z)[lanes]) {
  double re[lanes], im[lanes];
  for (int i = 0; i < lanes; ++i) re[i] = z[i].real(), im[i] = z[i].imag();
  return {P::load(re), P::load(im)};
}

std::complex<double> lane(const C& z, int i) { return {z.re[i], z.im[i]}; }

long double distance(const C& z, int i, Exact exact) { return std::abs(Exact(lane(z, i)) - exact); }

TEST(ComplexPacket, CalculatesLikeStdComplex) {
  Pcg32 random(3);
  for (int k = 0; k < 2000; ++k) {
    std::complex<double> a[lanes], b[lanes];
    for (int i = 0; i < lanes; ++i) {
      a[i] = {random.uniform(-3, 3), random.uniform(-3, 3)};
      b[i] = {random.uniform(-3, 3), random.uniform(-3, 3)};
    }
    const C x = packed(a), y = packed(b);
    const C sum = x + y, difference = x - y, product = x * y, quotient = x / y, mirrored = conj(x);
    const P square = norm(x);
    for (int i = 0; i < lanes; ++i) {
      const Exact u = a[i], v = b[i];
      const long double eps = 2e-16L;
      EXPECT_LE(distance(sum, i, u + v), eps * std::abs(u + v));
      EXPECT_LE(distance(difference, i, u - v), eps * std::abs(u - v));
      EXPECT_LE(distance(product, i, u * v), 2 * eps * std::abs(u * v));
      EXPECT_LE(distance(quotient, i, u / v), 4 * eps * std::abs(u / v));
      EXPECT_EQ(lane(mirrored, i), std::conj(a[i]));
      EXPECT_NEAR(square[i], static_cast<double>(std::norm(u)), 4e-16 * square[i]);
    }
  }
}

TEST(ComplexPacket, ARealNumberHasNoImaginaryPart) { EXPECT_EQ(lane(C(P(2.0)), 0), 2.0); }

// The root is the wave that decays: Im >= 0; on the positive real axis the one that runs forward.
void expect_forward_root(std::complex<double> square) {
  const std::complex<double> all[lanes] = {square, square, square, square, square, square, square, square};
  const C root = sqrt_upper(packed(all));
  Exact exact = std::sqrt(Exact(square));
  if (exact.imag() < 0 || (exact.imag() == 0 && exact.real() < 0)) exact = -exact;
  for (int i = 0; i < lanes; ++i) {
    EXPECT_GE(root.im[i], 0) << square;
    EXPECT_LE(distance(root, i, exact), 4e-16L * std::abs(exact)) << square << " gave " << lane(root, i);
    // Neither part drowns in the other: a weak loss stays as exact as the index.
    EXPECT_NEAR(root.re[i], static_cast<double>(exact.real()), 1e-15 * std::abs(static_cast<double>(exact.real())));
    EXPECT_NEAR(root.im[i], static_cast<double>(exact.imag()), 1e-15 * std::abs(static_cast<double>(exact.imag())));
  }
}

TEST(SqrtUpper, AllAround) {
  for (int degree = -180; degree <= 180; ++degree)
    for (const double size : {1e-12, 1e-3, 0.5, 1.0, 1.7, 16.0, 1e12}) {
      const double angle = degree * std::numbers::pi / 180;
      expect_forward_root({size * std::cos(angle), size * std::sin(angle)});
    }
}

TEST(SqrtUpper, BesideTheAxes) {
  for (const double along : {1e-6, 1.0, 2.25, 1e6})
    for (const double beside : {0.0, 1e-200, 1e-30, 1e-12, 1e-3})
      for (const double side : {-1.0, 1.0}) {
        expect_forward_root({along, side * beside});
        expect_forward_root({-along, side * beside});
        expect_forward_root({side * beside, along});
        expect_forward_root({side * beside, -along});
      }
}

TEST(SqrtUpper, OnTheAxesNothingIsLeftBeside) {
  const auto root = [](double re) { return lane(sqrt_upper(C(P(re))), 0); };
  EXPECT_EQ(root(4), 2.0);
  EXPECT_EQ(root(-4), std::complex<double>(0, 2));
  EXPECT_EQ(root(0), 0.0);
  const auto single = sqrt_upper(complex_packet<float, 4>(packet<float, 4>(0.0f)));
  EXPECT_EQ(single.re[0], 0);
  EXPECT_EQ(single.im[0], 0);
}

}  // namespace
}  // namespace shabon::math
