// Layers too thick to interfere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_stacks.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/no_interference.h"

namespace shabon::optics {
namespace {

constexpr double lambda_nm = 550;

TEST(Incoherent, OneLayerIsTheSumOfIntensities) {
  Pcg32 random(41);
  for (int i = 0; i < 2000; ++i) {
    const bool absorbing_incidence = i % 5 == 0;
    const std::complex<double> n1(random.uniform(1, 2), absorbing_incidence ? random.uniform(0, 0.1) : 0);
    const std::complex<double> n2(random.uniform(1, 2.5), i % 2 ? random.uniform(0, 1e-3) : 0);
    const std::complex<double> n3 = random_index(random, Absorption::some);
    const double d_nm = std::pow(10, random.uniform(2, 7));
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, absorbing_incidence ? 30 : 90)));
    const Powers slab = without_interference(n1, n2, n3, d_nm, incidence, lambda_nm);
    const Powers stack = stack_powers(ResolvedStack{n1, {{n2, d_nm, false}}, n3}, incidence, lambda_nm).powers;
    EXPECT_NEAR(stack.R_s, slab.R_s, 1e-13) << i;
    EXPECT_NEAR(stack.R_p, slab.R_p, 1e-13) << i;
    EXPECT_NEAR(stack.T_s, slab.T_s, 1e-13) << i;
    EXPECT_NEAR(stack.T_p, slab.T_p, 1e-13) << i;
  }
}

// Summing intensities is the mean over the layer's phase: the coherent answer at thicknesses that divide one period
// evenly. Without loss, where the mean is exact.
TEST(Incoherent, IsTheMeanOverPhase) {
  Pcg32 random(42);
  for (int i = 0; i < 30; ++i) {
    ResolvedStack stack = random_stack(random, Absorption::some);
    stack.layers.resize(std::min<std::size_t>(stack.layers.size(), 4));
    const auto thick = static_cast<std::size_t>(random.uniform(0, static_cast<double>(stack.layers.size())));
    const double n = random.uniform(2, 2.5);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 75)));
    const double period_nm = lambda_nm / (2 * normal_index(stack.n1, incidence, n).real());
    constexpr int steps = 4000;
    Powers mean;
    for (int step = 0; step < steps; ++step) {
      stack.layers[thick] = {n, 1000 * period_nm + period_nm * step / steps, true};
      const Powers at = stack_powers(stack, incidence, lambda_nm).powers;
      mean.R_s += at.R_s / steps;
      mean.R_p += at.R_p / steps;
      mean.T_s += at.T_s / steps;
      mean.T_p += at.T_p / steps;
    }
    stack.layers[thick].coherent = false;
    const Powers incoherent = stack_powers(stack, incidence, lambda_nm).powers;
    EXPECT_NEAR(incoherent.R_s, mean.R_s, 1e-10) << i;
    EXPECT_NEAR(incoherent.R_p, mean.R_p, 1e-10) << i;
    EXPECT_NEAR(incoherent.T_s, mean.T_s, 1e-10) << i;
    EXPECT_NEAR(incoherent.T_p, mean.T_p, 1e-10) << i;
  }
}

// Absorption of a film on either face of a thick plate: also the mean over the plate's phase.
TEST(Incoherent, AbsorptionOfTheCoatingsIsTheMeanOverPhase) {
  const Incidence incidence = incidence_from(Degrees(40));
  ResolvedStack stack{1, {{{2, 0.3}, 40}, {1.5, 0}, {{0.2, 3}, 15}, {1.4, 100}}, 1};
  const double period_nm = lambda_nm / (2 * normal_index(1, incidence, 1.5).real());
  constexpr int steps = 1000;
  std::vector<double> mean_s(4), mean_p(4);
  for (int step = 0; step < steps; ++step) {
    stack.layers[1].thickness_nm = period_nm * (100 + static_cast<double>(step) / steps);
    const StackPowers at = stack_powers(stack, incidence, lambda_nm);
    for (std::size_t m = 0; m < 4; ++m) {
      mean_s[m] += at.A_s[m] / steps;
      mean_p[m] += at.A_p[m] / steps;
    }
  }
  stack.layers[1].coherent = false;
  const StackPowers incoherent = stack_powers(stack, incidence, lambda_nm);
  for (std::size_t m = 0; m < 4; ++m) {
    EXPECT_NEAR(incoherent.A_s[m], mean_s[m], 1e-12) << m;
    EXPECT_NEAR(incoherent.A_p[m], mean_p[m], 1e-12) << m;
  }
  EXPECT_GT(incoherent.A_s[0], 0.1);
  EXPECT_GT(incoherent.A_s[2], 0.01);
}

// A pile of k plates: T = (1 - rho)/(1 + (2k - 1) rho) (Stokes 1862).
TEST(Incoherent, PileOfPlates) {
  const Incidence incidence = incidence_from(Degrees(56));
  const Powers wall = stack_powers(ResolvedStack{1, {}, 1.5}, incidence, lambda_nm).powers;
  for (int plates : {1, 2, 7, 100, 3000}) {
    ResolvedStack pile;
    for (int i = 0; i < plates; ++i) {
      pile.layers.push_back({1.5, 1e6, false});
      if (i + 1 < plates) pile.layers.push_back({1, 1e6, false});
    }
    const Powers found = stack_powers(pile, incidence, lambda_nm).powers;
    EXPECT_NEAR(found.T_s, (1 - wall.R_s) / (1 + (2 * plates - 1) * wall.R_s), 1e-12) << plates;
    EXPECT_NEAR(found.T_p, (1 - wall.R_p) / (1 + (2 * plates - 1) * wall.R_p), 1e-12) << plates;
  }
}

// A thick layer that lets nothing through: what lies behind it does not matter.
TEST(Incoherent, OpaqueLayer) {
  for (std::complex<double> n3 : {std::complex<double>(1), std::complex<double>(0.06, 3.6)}) {
    const ResolvedStack stack{1, {{1.38, 100}, {{1.5, 1e-2}, 1e9, false}, {2, 80}}, n3};
    const StackPowers found = stack_powers(stack, {}, lambda_nm);
    const Powers expected = stack_powers(ResolvedStack{1, {{1.38, 100}}, {1.5, 1e-2}}, {}, lambda_nm).powers;
    EXPECT_NEAR(found.powers.R_s, expected.R_s, 1e-15);
    EXPECT_NEAR(found.A_s[1], expected.T_s, 1e-15);
    EXPECT_EQ(found.powers.T_s, 0);
  }
}

}  // namespace
}  // namespace shabon::optics
