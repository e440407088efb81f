// Where formulas break: opaque and evanescent layers, grazing incidence, critical angles, no film at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "random_stacks.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;
constexpr double lambda_nm = 550;
const Complex silver(0.06, 3.6);

void expect_shares(const StackPowers& stack, double tolerance, const std::string& place) {
  const Powers& p = stack.powers;
  for (double share : {p.R_s, p.R_p, p.T_s, p.T_p}) {
    EXPECT_GE(share, 0) << place;
    EXPECT_LE(share, 1 + tolerance) << place;
  }
  EXPECT_NEAR(p.R_s + p.T_s + sum(stack.A_s), 1, tolerance) << place;
  EXPECT_NEAR(p.R_p + p.T_p + sum(stack.A_p), 1, tolerance) << place;
}

TEST(StackLimits, OpaqueSilver) {
  for (double thickness_nm : {1e4, 1e6, largest_thickness_nm})
    for (double angle_deg : {0.0, 45.0, 89.9}) {
      const Incidence incidence = incidence_from(Degrees(angle_deg));
      const ResolvedStack stack{1, {{1.4, 100}, {silver, thickness_nm}, {{2, 0.1}, 50}}, 1.5};
      const ResolvedStack half_space{1, {{1.4, 100}}, silver};
      const StackPowers found = stack_powers(stack, incidence, lambda_nm);
      const Powers expected = stack_powers(half_space, incidence, lambda_nm).powers;
      EXPECT_NEAR(found.powers.R_p, expected.R_p, 1e-14);
      EXPECT_NEAR(found.A_s[1], expected.T_s, 1e-14);
      EXPECT_NEAR(found.powers.T_s, 0, 1e-300);
      EXPECT_NEAR(found.A_p[2], 0, 1e-300);
      expect_shares(found, 1e-13, std::to_string(thickness_nm));
    }
}

// T of a gap between two prisms: 1/(1 + H^2 sinh^2 |beta|), (10) continued beyond the critical angle.
TEST(StackLimits, FrustratedTotalReflection) {
  const double n1 = 1.5, angle_deg = 60;
  const Incidence incidence = incidence_from(Degrees(angle_deg));
  const double q1 = n1 * incidence.cos_i, kappa = std::sqrt(n1 * n1 * incidence.sin_i * incidence.sin_i - 1);
  for (double gap_nm : {0.0, 1e-300, 10.0, 100.0, 1000.0, 10000.0}) {
    const double sinh = std::sinh(2 * std::numbers::pi * kappa * gap_nm / lambda_nm);
    const auto T = [&](double u1, double u2) { return 1 / (1 + std::pow((u1 / u2 + u2 / u1) / 2 * sinh, 2)); };
    const StackPowers found = stack_powers(ResolvedStack{n1, {{1, gap_nm}}, n1}, incidence, lambda_nm);
    const double T_s = T(q1, kappa), T_p = T(q1 / (n1 * n1), kappa);
    EXPECT_NEAR(found.powers.T_s, T_s, 1e-12 * T_s) << gap_nm;
    EXPECT_NEAR(found.powers.T_p, T_p, 1e-12 * T_p) << gap_nm;
    expect_shares(found, 1e-14, std::to_string(gap_nm));
  }
}

// A film coupled to a prism through a gap: without loss every angle reflects all; with a little loss the guided mode is
// seen as a dip, and the film takes what is missing.
TEST(StackLimits, PrismCoupling) {
  double least = 1;
  for (double angle_deg = 45; angle_deg < 89; angle_deg += 0.01) {
    const Incidence incidence = incidence_from(Degrees(angle_deg));
    const StackPowers lossless = stack_powers(ResolvedStack{1.8, {{1, 150}, {1.7, 300}}, 1.2}, incidence, 633);
    expect_shares(lossless, 1e-12, std::to_string(angle_deg));
    EXPECT_EQ(lossless.powers.T_s, 0);
    EXPECT_NEAR(lossless.powers.R_s, 1, 1e-12);
    const StackPowers lossy = stack_powers(ResolvedStack{1.8, {{1, 150}, {{1.7, 2e-3}, 300}}, 1.2}, incidence, 633);
    EXPECT_NEAR(lossy.A_s[1], 1 - lossy.powers.R_s, 1e-12);
    least = std::min(least, lossy.powers.R_s);
  }
  EXPECT_LT(least, 0.01);
}

// On both sides of the critical angle of every layer and half-space, and at it.
TEST(StackLimits, CriticalAngles) {
  const ResolvedStack stack{
      1.5, {{1.2, 200}, {1, 80}, {1.5, 120}, {1.2, 90}, {1, 100, false}, {{1.4, 1e-5}, 1e6, false}}, 1.5};
  for (bool coherent : {true, false})
    for (double n : {1.2, 1.0}) {
      ResolvedStack at = stack;
      if (coherent)
        for (ResolvedLayer& layer : at.layers) layer.coherent = true;
      const double sine = n / 1.5;
      for (double step : {0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-13, -1e-13}) {
        const double sin_i = sine + step;
        const StackPowers found = stack_powers(at, {std::sqrt((1 - sin_i) * (1 + sin_i)), sin_i}, lambda_nm);
        expect_shares(found, 1e-12, std::to_string(n) + " " + std::to_string(step));
        const StackPowers below =
            stack_powers(at, {std::sqrt(1 - (sine - 1e-10) * (sine - 1e-10)), sine - 1e-10}, lambda_nm);
        EXPECT_NEAR(found.powers.R_s, below.powers.R_s, 1e-3);
      }
    }
}

// Exactly at it: n = n1 sin_i to the last bit.
TEST(StackLimits, ExactlyAtACriticalAngle) {
  const Incidence incidence{0.8, 0.6};
  for (bool coherent : {true, false}) {
    const ResolvedStack stack{2.5, {{1.5, 100, coherent}, {1.8, 50}}, 2.5};
    const StackPowers found = stack_powers(stack, incidence, lambda_nm);
    expect_shares(found, 1e-14, "");
    EXPECT_NEAR(found.powers.R_p, coherent ? found.powers.R_p : 1, 1e-14);
    const ResolvedStack behind{2.5, {{1.8, 50}}, 1.5};
    EXPECT_NEAR(stack_powers(behind, incidence, lambda_nm).powers.R_s, 1, 1e-7);
  }
}

TEST(StackLimits, Grazing) {
  Pcg32 random(31);
  for (int i = 0; i < 200; ++i) {
    const ResolvedStack stack =
        i % 2 ? random_stack(random, Absorption::some) : random_mixed_stack(random, Absorption::some);
    const StackPowers at = stack_powers(stack, incidence_from(Degrees(90)), lambda_nm);
    EXPECT_NEAR(at.powers.R_s, 1, 1e-14);
    EXPECT_NEAR(at.powers.R_p, 1, 1e-14);
    EXPECT_EQ(at.powers.T_s, 0);
    EXPECT_EQ(at.powers.T_p, 0);
    EXPECT_EQ(sum(at.A_s), 0);
    EXPECT_EQ(sum(at.A_p), 0);
    for (double complement_deg = 1; complement_deg > 1e-13; complement_deg /= 30) {
      const double cosine = std::sin(complement_deg * std::numbers::pi / 180);
      expect_shares(stack_powers(stack, incidence_from_cos(cosine), lambda_nm), 1e-12, std::to_string(complement_deg));
    }
  }
}

TEST(StackLimits, EqualMediaAreInvisible) {
  for (double angle_deg : {0.0, 30.0, 89.9999999, 90.0})
    for (bool coherent : {true, false}) {
      const ResolvedStack stack{1.33, {{1.33, 700, coherent}, {2, 0, true}, {1.33, 1e6, coherent}}, 1.33};
      const StackPowers found = stack_powers(stack, incidence_from(Degrees(angle_deg)), lambda_nm);
      EXPECT_NEAR(found.powers.R_s, 0, 1e-25) << angle_deg;
      EXPECT_NEAR(found.powers.R_p, 0, 1e-25) << angle_deg;
      EXPECT_NEAR(found.powers.T_s, 1, 1e-13) << angle_deg;
      EXPECT_NEAR(found.powers.T_p, 1, 1e-13) << angle_deg;
      const Amplitudes amplitudes = stack_amplitudes(stack, incidence_from(Degrees(angle_deg)), lambda_nm);
      EXPECT_LT(std::abs(amplitudes.r_s), 1e-12) << angle_deg;
      EXPECT_LT(std::abs(amplitudes.r_p), 1e-12) << angle_deg;
      EXPECT_NEAR(std::abs(amplitudes.t_s), 1, 1e-13) << angle_deg;
      EXPECT_NEAR(std::abs(amplitudes.t_p), 1, 1e-13) << angle_deg;
    }
}

TEST(StackLimits, NormalIncidenceKnowsNoPolarisation) {
  Pcg32 random(32);
  for (int i = 0; i < 200; ++i) {
    const ResolvedStack stack = random_mixed_stack(random, Absorption::some);
    const StackPowers found = stack_powers(stack, {}, lambda_nm);
    EXPECT_NEAR(found.powers.R_s, found.powers.R_p, 1e-13);
    EXPECT_NEAR(found.powers.T_s, found.powers.T_p, 1e-13);
    for (std::size_t m = 0; m < found.A_s.size(); ++m) EXPECT_NEAR(found.A_s[m], found.A_p[m], 1e-13);
  }
}

// Numbers at the ends of what is allowed, in all combinations: every answer is a share.
TEST(StackLimits, Extremes) {
  const double indices[] = {1e-3, 1, 1.5, 10}, extinctions[] = {0, 1e-300, 1e-12, 1e-3, 10},
               thicknesses_nm[] = {0, std::numeric_limits<double>::denorm_min(), 1e-9, 300, largest_thickness_nm},
               angles_deg[] = {0, 41.810314895778596, 45, 89.999999, 90};
  for (double n : indices)
    for (double k : extinctions)
      for (double d_nm : thicknesses_nm)
        for (double angle_deg : angles_deg)
          for (bool coherent : {true, false})
            for (double n1 : {1.0, 1.5}) {
              const ResolvedStack stack{n1, {{1.3, 77}, {{n, k}, d_nm, coherent}, {{2, 1e-3}, 33}}, 1};
              const StackPowers found = stack_powers(stack, incidence_from(Degrees(angle_deg)), lambda_nm);
              std::string place = std::to_string(n) + " " + std::to_string(k) + " " + std::to_string(d_nm) + " ";
              place += std::to_string(angle_deg) + " " + std::to_string(coherent) + " " + std::to_string(n1);
              const bool waves_carry_power = coherent || k < 1e-3 * n;
              if (waves_carry_power) expect_shares(found, 1e-12, place);
              for (double A : {sum(found.A_s), sum(found.A_p)}) EXPECT_TRUE(A >= -1e-12 && A <= 1 + 1e-9) << place << A;
            }
}

// The same drawn at random, several at once, also where a layer marked incoherent is nothing of the kind.
TEST(StackLimits, RandomExtremes) {
  Pcg32 random(33);
  const auto pick = [&](const auto& list) {
    return list[static_cast<std::size_t>(random.uniform(0, std::size(list)))];
  };
  const double indices[] = {1e-3, 0.05, 1, 1.5, 2.4, 10}, extinctions[] = {0, 0, 0, 1e-300, 1e-12, 1e-6, 1e-3, 3},
               thicknesses_nm[] = {0, 1e-300, 1e-9, 50, 1e5, largest_thickness_nm},
               angles_deg[] = {0, 1e-9, 30, 41.810314895778596, 60, 89.999999, 90}, first_indices[] = {1, 1.5, 2.4};
  for (int i = 0; i < 20000; ++i) {
    ResolvedStack stack{pick(first_indices), {}, {pick(indices), pick(extinctions)}};
    for (double layers = random.uniform(1, 7); layers >= 1; --layers)
      stack.layers.push_back({{pick(indices), pick(extinctions)}, pick(thicknesses_nm), random.uniform() < 0.5});
    const StackPowers found = stack_powers(stack, incidence_from(Degrees(pick(angles_deg))), lambda_nm);
    expect_shares(found, 1e-4, std::to_string(i));
    for (ResolvedLayer& layer : stack.layers) layer.coherent = true;
    expect_shares(stack_powers(stack, incidence_from(Degrees(pick(angles_deg))), lambda_nm), 1e-11, std::to_string(i));
  }
}

}  // namespace
}  // namespace shabon::optics
