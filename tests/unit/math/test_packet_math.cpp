// The errors that packet_math.h states, over dense grids.
#include "shabon/math/packet_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace shabon::math {
namespace {

constexpr int lanes = 16;
using P = packet<float, lanes>;
constexpr double pi = std::numbers::pi;

// Calls function(x) with packets that step over [from, to] at `count` points, and check(i, lane's x).
template <class Check>
void sweep(double from, double to, int count, const Check& check) {
  for (int first = 0; first <= count; first += lanes) {
    float x[lanes];
    for (int i = 0; i < lanes; ++i) x[i] = static_cast<float>(from + (to - from) * std::min(first + i, count) / count);
    check(P::load(x));
  }
}

TEST(SinPi, AbsoluteError) {
  double worst = 0;
  sweep(-0.5, 0.5, 1 << 20, [&](P x) {
    const P s = sin_pi_reduced(x);
    for (int i = 0; i < lanes; ++i) worst = std::max(worst, std::abs(s[i] - std::sin(pi * static_cast<double>(x[i]))));
  });
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 1.8e-7);
}

// What narrow fringes need: the error vanishes where the sine does.
TEST(SinPi, RelativeError) {
  double worst = 0;
  for (const double limit : {0.5, 1e-2, 1e-4, 1e-8, 1e-20})
    sweep(-limit, limit, 1 << 16, [&](P x) {
      const P s = sin_pi_reduced(x);
      for (int i = 0; i < lanes; ++i) {
        const double exact = std::sin(pi * static_cast<double>(x[i]));
        worst = std::max(worst, exact == 0 ? std::abs(s[i]) : std::abs(s[i] / exact - 1));
      }
    });
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 2.5e-7);
}

TEST(SinPi, ErrorInDouble) {
  using D = packet<double, lanes>;
  double worst = 0, worst_relative = 0;
  for (const double limit : {0.5, 1e-3, 1e-12, 1e-100})
    for (int k = -100000; k <= 100000; ++k) {
      const double x = limit * k / 100000;
      const double s = sin_pi_reduced(D(x))[0];
      const long double exact = std::sin(std::numbers::pi_v<long double> * x);
      worst = std::max(worst, static_cast<double>(std::abs(s - exact)));
      if (k != 0) worst_relative = std::max(worst_relative, static_cast<double>(std::abs(s / exact - 1)));
    }
  EXPECT_EQ(sin_pi_reduced(D(0.0))[0], 0);
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 6e-16);
  EXPECT_LT(worst_relative, 6e-16);
}

TEST(CosPi, AbsoluteError) {
  double worst = 0;
  sweep(-0.5, 0.5, 1 << 20, [&](P x) {
    const P c = cos_pi_reduced(x);
    for (int i = 0; i < lanes; ++i) worst = std::max(worst, std::abs(c[i] - std::cos(pi * static_cast<double>(x[i]))));
  });
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 1.8e-7);
  EXPECT_EQ(cos_pi_reduced(P(0.0f))[0], 1);
}

TEST(CosPi, ErrorInDouble) {
  using D = packet<double, lanes>;
  double worst = 0;
  for (int k = -100000; k <= 100000; ++k) {
    const double x = 0.5 * k / 100000;
    const long double exact = std::cos(std::numbers::pi_v<long double> * x);
    worst = std::max(worst, static_cast<double>(std::abs(cos_pi_reduced(D(x))[0] - exact)));
  }
  EXPECT_EQ(cos_pi_reduced(D(0.0))[0], 1);
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 4e-16);
}

// The largest relative error of f(x) against exact(x), for x between `from` and `to`.
template <class T, class F, class Exact>
double worst_relative_error(double from, double to, const F& f, const Exact& exact) {
  using Q = packet<T, lanes>;
  double worst = 0;
  constexpr int steps = 200000;
  for (int k = 0; k <= steps; ++k) {
    const T x = static_cast<T>(from + (to - from) * k / steps);
    const long double there = exact(static_cast<long double>(x));
    const double error = static_cast<double>(std::abs(f(Q(x))[0] - there));
    worst = std::max(worst, there == 0 ? error : error / static_cast<double>(std::abs(there)));
  }
  return worst;
}

template <class T>
void expect_exp2_errors(double least_exponent, double stated, double stated_minus_1) {
  const auto power = [](auto x) { return exp2(x); };
  const auto less_1 = [](auto x) { return exp2_minus_1(x); };
  const auto exact = [](long double x) { return std::exp2(x); };
  const auto exact_less_1 = [](long double x) { return std::expm1(x * std::numbers::ln2_v<long double>); };
  EXPECT_LT(worst_relative_error<T>(least_exponent, 100, power, exact), stated);
  for (const double limit : {1e-6, 1e-3, 1.0, 10.0, 100.0})
    EXPECT_LT(worst_relative_error<T>(-limit, limit, less_1, exact_less_1), stated_minus_1) << limit;
  const packet<T, lanes> far(static_cast<T>(-1e6));
  EXPECT_EQ(exp2_minus_1(far)[lanes - 1], -1);
  EXPECT_EQ(exp2(far)[0], std::numeric_limits<T>::min());
}

TEST(Exp2, RelativeErrors) {
  expect_exp2_errors<float>(-126, 2e-7, 3e-7);
  expect_exp2_errors<double>(-1022, 5e-16, 1e-15);
}

TEST(Reciprocals, RelativeErrors) {
  const auto one_over = [](auto x) { return reciprocal(x); };
  const auto one_over_root = [](auto x) { return reciprocal_sqrt(x); };
  const auto exact = [](long double x) { return 1 / x; };
  const auto exact_root = [](long double x) { return 1 / std::sqrt(x); };
  for (const double size : {1e-30, 1e-3, 1.0, 1e6, 1e29}) {
    EXPECT_LT(worst_relative_error<float>(size, 9 * size, one_over, exact), 2e-7);
    EXPECT_LT(worst_relative_error<double>(size, 9 * size, one_over, exact), 5e-16);
    EXPECT_LT(worst_relative_error<float>(size, 9 * size, one_over_root, exact_root), 2e-7);
    EXPECT_LT(worst_relative_error<double>(size, 9 * size, one_over_root, exact_root), 5e-16);
  }
}

TEST(Atan2, AbsoluteErrorAllAround) {
  double worst = 0;
  for (const double size : {1.0, 3.7, 1e-30, 1e30})
    sweep(-pi, pi, 1 << 18, [&](P angle) {
      float x[lanes], y[lanes];
      for (int i = 0; i < lanes; ++i) {
        x[i] = static_cast<float>(size * std::cos(static_cast<double>(angle[i])));
        y[i] = static_cast<float>(size * std::sin(static_cast<double>(angle[i])));
      }
      const P result = atan2(P::load(y), P::load(x));
      for (int i = 0; i < lanes; ++i)
        worst = std::max(worst, std::abs(result[i] - std::atan2(static_cast<double>(y[i]), static_cast<double>(x[i]))));
    });
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 4e-7);
}

TEST(Atan2, AxesAndDiagonals) {
  for (const double y : {-1.0, 0.0, 1.0})
    for (const double x : {-1.0, 0.0, 1.0}) {
      const P result = atan2(P(static_cast<float>(y)), P(static_cast<float>(x)));
      EXPECT_NEAR(result[3], std::atan2(y, x), 4e-7) << y << " " << x;
    }
  EXPECT_EQ(atan2(P(0.0f), P(0.0f))[0], 0);
  EXPECT_EQ(atan2(P(-0.0f), P(0.0f))[0], 0);
}

TEST(Acos, AbsoluteError) {
  double worst = 0;
  const auto check = [&](P x) {
    const P angle = acos(x);
    for (int i = 0; i < lanes; ++i) worst = std::max(worst, std::abs(angle[i] - std::acos(static_cast<double>(x[i]))));
  };
  sweep(-1, 1, 1 << 20, check);
  sweep(-1, -1 + 1e-4, 1 << 14, check);
  sweep(1 - 1e-4, 1, 1 << 14, check);
  RecordProperty("worst", testing::PrintToString(worst));
  EXPECT_LT(worst, 4e-7);
}

TEST(Acos, ClampsWhatLiesBeyondOne) {
  EXPECT_EQ(acos(P(1.0f + 1e-6f))[0], 0);
  EXPECT_EQ(acos(P(2.0f))[0], 0);
  EXPECT_NEAR(acos(P(-1.0f - 1e-6f))[0], pi, 4e-7);
  EXPECT_NEAR(acos(P(-2.0f))[0], pi, 4e-7);
}

}  // namespace
}  // namespace shabon::math
