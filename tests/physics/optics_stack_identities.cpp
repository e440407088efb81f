// Changes of a stack that change nothing, and stacks whose answer is known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_stacks.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;
constexpr int tries = 1000;
constexpr double lambda_nm = 550;

// Amplitudes above 1 are compared by their ratio; behind an absorbing first medium they can be any size.
void expect_same(const Amplitudes& a, const Amplitudes& b, double tolerance, int i) {
  EXPECT_LT(std::abs(a.r_s - b.r_s), tolerance * (1 + norm(b.r_s))) << i;
  EXPECT_LT(std::abs(a.r_p - b.r_p), tolerance * (1 + norm(b.r_p))) << i;
  EXPECT_LT(std::abs(a.t_s - b.t_s), tolerance * (1 + norm(b.t_s))) << i;
  EXPECT_LT(std::abs(a.t_p - b.t_p), tolerance * (1 + norm(b.t_p))) << i;
}

TEST(StackIdentities, OneLayerIsAiry) {
  Pcg32 random(21);
  for (int i = 0; i < tries; ++i) {
    const Complex n1(random.uniform(1, 2), i % 4 == 0 ? random.uniform(0, 0.5) : 0);
    const Complex n2 = random_index(random, Absorption::some), n3 = random_index(random, Absorption::some);
    const double d_nm = std::pow(10, random.uniform(-3, 6));
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    expect_same(stack_amplitudes(ResolvedStack{n1, {{n2, d_nm}}, n3}, incidence, lambda_nm),
                airy_amplitudes(n1, n2, n3, d_nm, incidence, lambda_nm), 1e-13, i);
  }
}

TEST(StackIdentities, NoLayersAreTheInterface) {
  Pcg32 random(22);
  for (int i = 0; i < tries; ++i) {
    const Complex n1 = random.uniform(1, 2), n3 = random_index(random, Absorption::some);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const InterfaceAmplitudes bare = fresnel(n1, incidence.cos_i, n3, refracted_cosine(n1, incidence, n3));
    expect_same(stack_amplitudes(ResolvedStack{n1, {}, n3}, incidence, lambda_nm),
                {bare.r_s, bare.r_p, bare.t_s, bare.t_p}, 1e-14, i);
  }
}

TEST(StackIdentities, ALayerSplitInTwo) {
  Pcg32 random(23);
  for (int i = 0; i < tries; ++i) {
    const ResolvedStack whole =
        i % 2 ? random_stack(random, Absorption::some) : random_mixed_stack(random, Absorption::some);
    const auto at = static_cast<std::size_t>(random.uniform(0, static_cast<double>(whole.layers.size())));
    const double share = random.uniform();
    ResolvedStack split = whole;
    split.layers.insert(split.layers.begin() + static_cast<std::ptrdiff_t>(at), whole.layers[at]);
    split.layers[at].thickness_nm *= share;
    split.layers[at + 1].thickness_nm *= 1 - share;
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    if (i % 2 == 1)
      expect_same(stack_amplitudes(split, incidence, lambda_nm), stack_amplitudes(whole, incidence, lambda_nm), 1e-12,
                  i);
    const StackPowers a = stack_powers(whole, incidence, lambda_nm), b = stack_powers(split, incidence, lambda_nm);
    EXPECT_NEAR(a.powers.R_s, b.powers.R_s, 1e-12) << i;
    EXPECT_NEAR(a.powers.T_p, b.powers.T_p, 1e-12) << i;
    EXPECT_NEAR(a.A_s[at], b.A_s[at] + b.A_s[at + 1], 1e-12) << i;
    EXPECT_NEAR(a.A_p[at], b.A_p[at] + b.A_p[at + 1], 1e-12) << i;
  }
}

TEST(StackIdentities, ALayerWithoutThickness) {
  Pcg32 random(24);
  for (int i = 0; i < tries; ++i) {
    const ResolvedStack without = random_stack(random, Absorption::some);
    ResolvedStack with = without;
    const auto at = static_cast<std::ptrdiff_t>(random.uniform(0, static_cast<double>(without.layers.size() + 1)));
    with.layers.insert(with.layers.begin() + at, {random_index(random, Absorption::some), 0});
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    expect_same(stack_amplitudes(with, incidence, lambda_nm), stack_amplitudes(without, incidence, lambda_nm), 1e-14,
                i);
    EXPECT_EQ(stack_powers(with, incidence, lambda_nm).A_p[static_cast<std::size_t>(at)], 0);
  }
}

// A half wave anywhere in the stack is absent.
TEST(StackIdentities, AHalfWaveIsAbsent) {
  Pcg32 random(25);
  for (int i = 0; i < tries; ++i) {
    const ResolvedStack without = random_stack(random, Absorption::some);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 60)));
    const double n = random.uniform(2, 3);
    ResolvedStack with = without;
    const auto at = static_cast<std::ptrdiff_t>(random.uniform(0, static_cast<double>(without.layers.size() + 1)));
    with.layers.insert(with.layers.begin() + at, {n, lambda_nm / (2 * normal_index(without.n1, incidence, n).real())});
    const Amplitudes a = stack_amplitudes(with, incidence, lambda_nm);
    const Amplitudes b = stack_amplitudes(without, incidence, lambda_nm);
    expect_same({a.r_s, a.r_p, -a.t_s, -a.t_p}, b, 1e-12, i);
  }
}

// Two quarter waves of n3 = (n_b/n_a)^2 n1 make a zero.
TEST(StackIdentities, QuarterWaveZeros) {
  const auto R = [](const ResolvedStack& stack) { return stack_powers(stack, {}, lambda_nm).powers.R_s; };
  const double n3 = 1.52, single = std::sqrt(n3), inner = 1.38 * std::sqrt(n3);
  EXPECT_LT(R({1, {{single, lambda_nm / (4 * single)}}, n3}), 1e-30);
  EXPECT_LT(R({1, {{1.38, lambda_nm / (4 * 1.38)}, {inner, lambda_nm / (4 * inner)}}, n3}), 1e-30);
  EXPECT_GT(R({1, {{1.38, lambda_nm / (4 * 1.38)}, {inner, lambda_nm / (5 * inner)}}, n3}), 1e-3);
}

// N pairs of quarter waves act as a medium of index (n_H/n_L)^(2N) n3 (Macleod, Thin-Film Optical Filters,
// section 6.1).
TEST(StackIdentities, BraggMirror) {
  const double high = 2.4, low = 1.46, n3 = 1.52;
  for (int pairs : {1, 2, 5, 10, 20, 40, 100, 5000}) {
    ResolvedStack stack{1, {}, n3};
    for (int i = 0; i < pairs; ++i) {
      stack.layers.push_back({high, lambda_nm / (4 * high)});
      stack.layers.push_back({low, lambda_nm / (4 * low)});
    }
    const double index = std::pow(high / low, 2 * pairs) * n3;
    const double R = std::isinf(index) ? 1 : std::pow((1 - index) / (1 + index), 2);
    const double T = std::isinf(index) ? 0 : 4 / index / std::pow(1 + 1 / index, 2);
    const StackPowers found = stack_powers(stack, {}, lambda_nm);
    EXPECT_NEAR(found.powers.R_s, R, 1e-13) << pairs;
    EXPECT_NEAR(found.powers.R_p, R, 1e-13) << pairs;
    EXPECT_NEAR(found.powers.T_s, T, 1e-12 * T) << pairs;  // to its last digits, however small
    EXPECT_NEAR(found.powers.T_p, T, 1e-12 * T) << pairs;
    EXPECT_NEAR(stack_amplitudes(stack, {}, lambda_nm).r_s.real(), -std::sqrt(R), 1e-13) << pairs;
  }
}

// A mirror of that kind, of 10 000 layers, at angles at which light still goes through: nothing is lost or gained.
TEST(StackIdentities, TenThousandLayers) {
  ResolvedStack stack{1, {}, 1.52};
  for (int i = 0; i < most_layers / 2; ++i) {
    stack.layers.push_back({2.4, 57.3});
    stack.layers.push_back({1.46, 94.2});
  }
  for (double nm = 360; nm < 830; nm += 17)
    for (double angle_deg : {0.0, 35.0, 89.0, 90.0}) {
      const StackPowers found = stack_powers(stack, incidence_from(Degrees(angle_deg)), nm);
      EXPECT_NEAR(found.powers.R_s + found.powers.T_s, 1, 1e-11) << nm << " " << angle_deg;
      EXPECT_NEAR(found.powers.R_p + found.powers.T_p, 1, 1e-11) << nm << " " << angle_deg;
    }
  for (ResolvedLayer& layer : stack.layers) layer.n += Complex(0, 1e-6);
  const StackPowers found = stack_powers(stack, {}, 720);
  EXPECT_NEAR(found.powers.R_s + found.powers.T_s + sum(found.A_s), 1, 1e-11);
  EXPECT_GT(sum(found.A_s), 0.001);
}

// The same number of layers of one medium is one layer of it.
TEST(StackIdentities, TenThousandLayersOfOneMedium) {
  for (Complex n : {Complex(1.5), Complex(1.5, 1e-5), Complex(0.2, 3.4)}) {
    const ResolvedStack stack{1, std::vector<ResolvedLayer>(most_layers, {n, 7.3}), 2};
    const Incidence incidence = incidence_from(Degrees(50));
    expect_same(stack_amplitudes(stack, incidence, lambda_nm),
                airy_amplitudes(1, n, 2, 7.3 * most_layers, incidence, lambda_nm), 1e-10, 0);
  }
}

}  // namespace
}  // namespace shabon::optics
