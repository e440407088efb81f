// Energy and reciprocity of stacks, tried on random ones, coherent and mixed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_stacks.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {
namespace {

constexpr int tries = 2000;

// Each A from the fields at the layer's two faces; R and T from the amplitudes.
void expect_all_accounted_for(const StackPowers& stack, double tolerance, int i) {
  EXPECT_NEAR(stack.powers.R_s + stack.powers.T_s + sum(stack.A_s), 1, tolerance) << i;
  EXPECT_NEAR(stack.powers.R_p + stack.powers.T_p + sum(stack.A_p), 1, tolerance) << i;
  for (const auto& A : {stack.A_s, stack.A_p})
    for (double share : A) {
      EXPECT_GE(share, 0) << i;
      EXPECT_LE(share, 1 + tolerance) << i;
    }
  for (double share : {stack.powers.R_s, stack.powers.R_p, stack.powers.T_s, stack.powers.T_p}) {
    EXPECT_GE(share, 0) << i;
    EXPECT_LE(share, 1 + tolerance) << i;
  }
}

TEST(StackEnergy, ReflectedTransmittedAbsorbed) {
  Pcg32 random(11);
  for (int i = 0; i < tries; ++i) {
    const Absorption absorption = i % 3 == 0 ? Absorption::none : Absorption::some;
    ResolvedStack stack = random_stack(random, absorption);
    if (i % 5 == 0) stack.n3 = random_index(random, absorption);
    const StackPowers powers =
        stack_powers(stack, incidence_from(Degrees(random.uniform(0, 90))), random.uniform(360, 830));
    expect_all_accounted_for(powers, 1e-12, i);
    if (absorption == Absorption::none) {
      EXPECT_EQ(sum(powers.A_s) + sum(powers.A_p), 0);
    }
  }
}

TEST(StackEnergy, MixedStacks) {
  Pcg32 random(12);
  for (int i = 0; i < tries; ++i) {
    const ResolvedStack stack = random_mixed_stack(random, i % 2 ? Absorption::some : Absorption::none);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    expect_all_accounted_for(stack_powers(stack, incidence, random.uniform(360, 830)), 1e-12, i);
  }
}

// The powers of the amplitudes and those of the fields are two ways to the same.
TEST(StackEnergy, PowersOfTheAmplitudes) {
  Pcg32 random(13);
  for (int i = 0; i < tries; ++i) {
    ResolvedStack stack = random_stack(random, Absorption::some);
    if (i % 3 == 0) stack.n1 += std::complex<double>(0, random.uniform(0, 0.5));
    if (i % 5 == 0) stack.n3 = random_index(random, Absorption::some);
    const Incidence incidence = incidence_from(Degrees(random.uniform(0, 90)));
    const Powers fields = stack_powers(stack, incidence, 550).powers;
    const Powers amplitudes = powers_of(stack_amplitudes(stack, incidence, 550), stack.n1, stack.n3, incidence);
    EXPECT_NEAR(fields.R_s, amplitudes.R_s, 1e-13 * (1 + fields.R_s)) << i;
    EXPECT_NEAR(fields.R_p, amplitudes.R_p, 1e-13 * (1 + fields.R_p)) << i;
    EXPECT_NEAR(fields.T_s, amplitudes.T_s, 1e-13 * (1 + std::abs(fields.T_s))) << i;
    EXPECT_NEAR(fields.T_p, amplitudes.T_p, 1e-13 * (1 + std::abs(fields.T_p))) << i;
  }
}

// Light from the other side at the angle at which it left: the same T, and without absorption the same R.
void expect_reciprocal(const ResolvedStack& stack, double angle_deg, bool lossless, int i) {
  const Incidence there = incidence_from(Degrees(angle_deg));
  const std::complex<double> c3 = refracted_cosine(stack.n1, there, stack.n3);
  if (c3.imag() != 0) return;
  const Powers forward = stack_powers(stack, there, 550).powers;
  const Powers back = stack_powers(reversed(stack), incidence_from_cos(c3.real()), 550).powers;
  EXPECT_NEAR(forward.T_s, back.T_s, 1e-12) << i;
  EXPECT_NEAR(forward.T_p, back.T_p, 1e-12) << i;
  if (!lossless) return;
  EXPECT_NEAR(forward.R_s, back.R_s, 1e-12) << i;
  EXPECT_NEAR(forward.R_p, back.R_p, 1e-12) << i;
}

TEST(StackReciprocity, TransmittanceFromBothSides) {
  Pcg32 random(14);
  for (int i = 0; i < tries; ++i) {
    const bool lossless = i % 2 == 0;
    const Absorption absorption = lossless ? Absorption::none : Absorption::some;
    expect_reciprocal(random_stack(random, absorption), random.uniform(0, 85), lossless, i);
    expect_reciprocal(random_mixed_stack(random, absorption), random.uniform(0, 85), lossless, i);
  }
}

TEST(StackReciprocity, ReversedTwiceIsTheSame) {
  const Stack stack{Medium::constant(1.5), {{Medium::constant(2), 10}, {Medium::constant(3), 20, false}}, Medium()};
  EXPECT_NE(reversed(stack), stack);
  EXPECT_EQ(reversed(stack).layers[0].thickness_nm, 20);
  EXPECT_EQ(reversed(reversed(stack)), stack);
}

// Behind an opaque mirror little arrives, but what arrives is shared out with all digits: a very thick layer takes what
// a half-space in its place would.
TEST(StackEnergy, BehindAnOpaqueLayer) {
  const std::complex<double> silver(0.06, 3.6), silicon(4.08, 0.03);
  for (double thickness_nm : {50.0, 500.0, 5000.0})
    for (double angle_deg : {0.0, 60.0}) {
      const Incidence incidence = incidence_from(Degrees(angle_deg));
      const StackPowers thick =
          stack_powers(ResolvedStack{1, {{silver, thickness_nm}, {silicon, 1e6}}, 1}, incidence, 550);
      const Powers half_space =
          stack_powers(ResolvedStack{1, {{silver, thickness_nm}}, silicon}, incidence, 550).powers;
      EXPECT_NEAR(thick.A_s[1] / half_space.T_s, 1, 1e-12) << thickness_nm;
      EXPECT_NEAR(thick.A_p[1] / half_space.T_p, 1, 1e-12) << thickness_nm;
      EXPECT_LT(half_space.T_s, std::exp(-0.06 * thickness_nm));
    }
}

}  // namespace
}  // namespace shabon::optics
