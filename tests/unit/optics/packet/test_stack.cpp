// The stack kernel against the reference: every number is one that float holds, so that both see the same stack.
#include "shabon/optics/packet/stack.h"

#include <gtest/gtest.h>

#include "film_cases.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {
namespace {

using Complex = std::complex<double>;

constexpr double required_of_stacks = 5e-6;  // R, T and Mueller blocks, against double
constexpr double kept_energy = 4e-7;         // R + T - 1 of lossless stacks
constexpr double stated_in_double = 1e-11;

std::vector<double> sixteen_wavelengths(Pcg32& random) {
  std::vector<double> result;
  const double shift = random.uniform();
  for (int i = 0; i < lanes; ++i) result.push_back(as_float(360 + 470 * (i + shift) / lanes));
  return result;
}

// One index, or one for each wavelength around it.
Medium medium_around(Complex n, bool dispersive, const std::vector<double>& wavelengths_nm, Pcg32& random) {
  const Complex rounded(as_float(n.real()), as_float(n.imag()));
  if (!dispersive) return Medium::constant(rounded);
  std::vector<IndexSample> rows;
  for (const double nm : wavelengths_nm)
    rows.push_back({nm, as_float(n.real() * random.uniform(0.97, 1.03)), rounded.imag()});
  return *Medium::table(rows, {});
}

struct StackCase {
  Stack stack;
  std::vector<double> wavelengths_nm;
  double cos_i;
};

enum class Kind { dielectric, any };

// 1 to 40 layers of index 1.3 to 2.6, sometimes all alike or quarter waves; `any` adds metals and low indices.
StackCase random_stack(Pcg32& random, Kind kind, double largest_angle_deg) {
  StackCase it{{}, sixteen_wavelengths(random), cosine_of_degrees(random.uniform(0, largest_angle_deg))};
  const int count = 1 + static_cast<int>(random() % 40);
  const bool dispersive = random() % 2, periodic = random() % 3 == 0, quarter_waves = random() % 3 == 0;
  const double pair[2] = {random.uniform(1.3, 2.6), random.uniform(1.3, 2.6)};
  for (int j = 0; j < count; ++j) {
    Complex n = periodic ? pair[j % 2] : random.uniform(1.3, 2.6);
    if (kind == Kind::any && random() % 4 == 0) n = {random.uniform(0.05, 4), random.uniform(0, 5)};
    if (kind == Kind::any && random() % 4 == 0) n = random.uniform(0.8, 1.5);
    const double most_nm = n.imag() > 0 ? 100 : random() % 4 ? 300 : 3000;
    it.stack.layers.push_back({medium_around(n, dispersive, it.wavelengths_nm, random),
                               as_float(quarter_waves ? 140 / n.real() : random.uniform(0, most_nm)), true});
  }
  if (kind == Kind::any && random() % 3 == 0) it.stack.incidence = Medium::constant(as_float(1.52));
  const Complex exits[] = {it.stack.incidence.index(500), as_float(1.52), {as_float(0.9), as_float(2.5)}};
  it.stack.exit = Medium::constant(exits[random() % (kind == Kind::any ? 3 : 2)]);
  return it;
}

std::string text_of(const StackCase& it, int lane) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu layers, %.5f deg, %.6g nm", it.stack.layers.size(),
                std::acos(it.cos_i) * 180 / std::numbers::pi, it.wavelengths_nm[static_cast<std::size_t>(lane)]);
  return text;
}

struct Errors {
  Worst powers, blocks, energy, float_per_light;
  int needed_double = 0, packets = 0;

  void expect() const {
    powers.expect_within(required_of_stacks, "R and T");
    blocks.expect_within(required_of_stacks, "Mueller blocks");
    energy.expect_within(kept_energy, "R + T - 1");
    float_per_light.expect_within(required_of_stacks / most_light_inside, "float, per light inside");
    std::printf("[ measured ] %d of %d packets in double\n", needed_double, packets);
  }
};

template <class Where>
void compare_block(const MuellerBlock<lanes>& block, int i, double s, double p, Complex both, const Where& where,
                   Worst& worst) {
  worst.see(std::abs(block.a[i] - (s + p) / 2), where);
  worst.see(std::abs(block.b[i] - (s - p) / 2), where);
  worst.see(std::abs(block.c[i] - both.real()), where);
  worst.see(std::abs(block.d[i] - both.imag()), where);
}

// What float alone makes of it: the error of R and T follows the light inside.
void see_float(const StackCase& it, const StackTable& table, Errors& errors) {
  constexpr int leaf = math::register_bytes / 4;
  // More layers that are alike round alike, and their errors no longer add up as squares.
  const bool few = table.layers.size() <= 2 * most_layers_in_float;
  for (std::size_t first = 0; first < lanes; first += leaf, ++errors.packets) {
    const auto rough = cross_stack<float, leaf>(table, first, {.cos_i = it.cos_i});
    const auto exact = cross_stack<double, leaf>(table, first, {.cos_i = it.cos_i});
    errors.needed_double += needs_double(rough);
    const auto see = [&](const StackSide<float, leaf>& side, const StackSide<double, leaf>& exact_side) {
      const auto powers = powers_of(side, rough.lossless);
      const auto exact_powers = powers_of(exact_side, exact.lossless);
      const auto light = light_inside(side);
      for (int i = 0; i < leaf; ++i)
        for (std::size_t k = 0; k < 2; ++k)
          if (few && std::isfinite(light[i]))
            errors.float_per_light.see(std::abs(powers[k][i] - exact_powers[k][i]) / (1 + light[i]),
                                       [&] { return text_of(it, static_cast<int>(first) + i); });
    };
    see(rough.s, exact.s), see(rough.p, exact.p);
  }
}

void compare(const StackCase& it, Errors& errors) {
  const StackTable table(it.stack, it.wavelengths_nm);
  const FilmPowers<lanes> fast = stack_powers<lanes>(table, 0, {.cos_i = it.cos_i});
  const FilmMueller<lanes> rows = stack_mueller<lanes>(table, 0, {.cos_i = it.cos_i});
  const Incidence incidence = incidence_from_cos(it.cos_i);
  see_float(it, table, errors);
  for (int i = 0; i < lanes; ++i) {
    const double nm = it.wavelengths_nm[static_cast<std::size_t>(i)];
    const auto where = [&] { return text_of(it, i); };
    const Amplitudes exact = stack_amplitudes(resolve(it.stack, nm), incidence, nm);
    const Powers powers = powers_of(exact, it.stack.incidence.index(nm), it.stack.exit.index(nm), incidence);
    errors.powers.see(std::abs(fast.R_s[i] - powers.R_s), where);
    errors.powers.see(std::abs(fast.R_p[i] - powers.R_p), where);
    errors.powers.see(std::abs(fast.T_s[i] - powers.T_s), where);
    errors.powers.see(std::abs(fast.T_p[i] - powers.T_p), where);
    compare_block(rows.reflected, i, powers.R_s, powers.R_p, exact.r_s * conj(exact.r_p), where, errors.blocks);
    if (table.equal_outer_media)
      compare_block(rows.transmitted, i, powers.T_s, powers.T_p, exact.t_s * conj(exact.t_p), where, errors.blocks);
    if (!table.lossless || !it.stack.exit.is_lossless()) continue;
    errors.energy.see(std::abs(static_cast<double>(fast.R_s[i]) + fast.T_s[i] - 1), where);
    errors.energy.see(std::abs(static_cast<double>(rows.reflected.a[i]) + rows.transmitted.a[i] - 1), where);
  }
}

TEST(PacketStack, DielectricStacksAgreeWithTheReference) {
  Errors errors;
  Pcg32 random(1989);
  for (int k = 0; k < 6000; ++k) compare(random_stack(random, Kind::dielectric, 80), errors);
  errors.expect();
  EXPECT_GT(errors.needed_double, 0);
  EXPECT_LT(errors.needed_double, errors.packets);
}

// Metals, layers beyond their critical angle, light from glass, absorbing and totally reflecting exits.
TEST(PacketStack, AnyStacksAgreeWithTheReference) {
  Errors errors;
  Pcg32 random(7);
  for (int k = 0; k < 6000; ++k) compare(random_stack(random, Kind::any, 89.9), errors);
  errors.expect();
}

template <class T, int N>
Complex lane_of(const math::complex_packet<T, N>& z, int i) {
  return {z.re[i], z.im[i]};
}

// t of s and p may have the other sign, both of them; that of p is a ratio of magnetic fields.
TEST(PacketStack, AmplitudesInDoubleLanes) {
  constexpr int leaf = math::register_bytes / 8;
  Worst worst;
  Pcg32 random(3);
  for (int k = 0; k < 1500; ++k) {
    const StackCase it = random_stack(random, k % 2 ? Kind::any : Kind::dielectric, 89.9);
    const StackTable table(it.stack, it.wavelengths_nm);
    for (int first = 0; first < lanes; first += leaf) {
      const auto sides = cross_stack<double, leaf>(table, static_cast<std::size_t>(first), {.cos_i = it.cos_i});
      const auto s = amplitudes_of(sides.s, sides.lossless), p = amplitudes_of(sides.p, sides.lossless);
      for (int i = 0; i < leaf; ++i) {
        const double nm = it.wavelengths_nm[static_cast<std::size_t>(first + i)];
        const auto where = [&] { return text_of(it, first + i); };
        const ResolvedStack resolved = resolve(it.stack, nm);
        const Amplitudes exact = stack_amplitudes(resolved, incidence_from_cos(it.cos_i), nm);
        worst.see(std::abs(lane_of(s.r, i) - exact.r_s), where);
        worst.see(std::abs(lane_of(p.r, i) - exact.r_p), where);
        const Complex t_s = lane_of(s.t, i), t_p = lane_of(p.t, i) * resolved.n1 / resolved.n3;
        const double sign = std::abs(t_s - exact.t_s) < std::abs(t_s + exact.t_s) ? 1 : -1;
        worst.see(std::abs(t_s - sign * exact.t_s), where);
        worst.see(std::abs(t_p - sign * exact.t_p), where);
      }
    }
  }
  worst.expect_within(stated_in_double, "r and t");
}

StackCase case_of(Stack stack, double cos_i) {
  Pcg32 random(5);
  return {std::move(stack), sixteen_wavelengths(random), cos_i};
}

// Two quarter-wave mirrors around a half wave: light inside is a thousand times what falls on it, in a narrow band.
TEST(PacketStack, NarrowBandsAreEvaluatedInDouble) {
  const Layer high{Medium::constant(as_float(2.35)), as_float(550 / 4.0 / 2.35), true};
  const Layer low{Medium::constant(as_float(1.38)), as_float(550 / 4.0 / 1.38), true};
  Stack filter;
  for (int j = 0; j < 7; ++j) filter.layers.push_back(high), filter.layers.push_back(low);
  filter.layers.push_back({high.medium, 2 * high.thickness_nm, true});
  for (int j = 0; j < 7; ++j) filter.layers.push_back(low), filter.layers.push_back(high);
  Errors errors;
  for (int step = 0; step < 40; ++step) {
    StackCase it = case_of(filter, 1);
    for (int i = 0; i < lanes; ++i)
      it.wavelengths_nm[static_cast<std::size_t>(i)] = as_float(550 + 1e-3 * (step - 20) + 0.01 * (i - 8));
    compare(it, errors);
  }
  errors.expect();
  EXPECT_EQ(errors.needed_double, errors.packets);
}

// Light guided in a layer behind one that it cannot cross: the field in front is a small difference of large numbers.
TEST(PacketStack, GuidedLightBehindOpaqueLayers) {
  Stack guide;
  guide.incidence = guide.exit = Medium::constant(as_float(1.52));
  const std::pair<Complex, double> layers[] = {{2.453, 135.7}, {1.46, 2534.2}, {1.6, 1374}, {1.334, 266.4}};
  for (const auto& [n, thickness_nm] : layers)
    guide.layers.push_back({Medium::constant(as_float(n.real())), as_float(thickness_nm), true});
  guide.layers.push_back({Medium::constant({as_float(0.1052), as_float(1.085)}), as_float(35.5), true});
  Errors errors;
  for (int step = 0; step < 2000; ++step) {
    StackCase it = case_of(guide, as_float(0.17 + 1e-5 * step));
    for (int i = 0; i < lanes; ++i) it.wavelengths_nm[static_cast<std::size_t>(i)] = as_float(452 + 0.06 * i);
    compare(it, errors);
  }
  errors.expect();
}

TEST(PacketStack, LightFromTheExitSideSeesTheStackReversed) {
  constexpr float fused_rounding = 1e-7f;  // of numbers up to 1: about one unit in the last place
  Pcg32 random(11);
  Worst worst;
  for (int k = 0; k < 500; ++k) {
    StackCase it = random_stack(random, Kind::any, 85);
    it.stack.exit = it.stack.incidence;
    const StackTable ahead(it.stack, it.wavelengths_nm), behind(reversed(it.stack), it.wavelengths_nm);
    const auto a = stack_mueller<lanes>(ahead, 0, {.cos_i = it.cos_i, .from_exit = true});
    const auto b = stack_mueller<lanes>(behind, 0, {.cos_i = it.cos_i});
    const auto c = stack_mueller<lanes>(ahead, 0, {.cos_i = it.cos_i});
    for (int i = 0; i < lanes; ++i) {
      const auto where = [&] { return text_of(it, i); };
      // The same arithmetic; but where the compiler fuses a*b+c it may do so differently at each place of call.
      EXPECT_NEAR(a.reflected.a[i], b.reflected.a[i], fused_rounding);
      EXPECT_NEAR(a.reflected.d[i], b.reflected.d[i], fused_rounding);
      worst.see(std::abs(a.transmitted.a[i] - c.transmitted.a[i]), where);
      worst.see(std::abs(a.transmitted.d[i] - c.transmitted.d[i]), where);
    }
  }
  worst.expect_within(required_of_stacks, "T from both sides");
}

TEST(PacketStack, OneLayerMayHaveAnotherThickness) {
  Pcg32 random(12);
  for (int k = 0; k < 200; ++k) {
    StackCase it = random_stack(random, Kind::any, 85);
    const StackTable before(it.stack, it.wavelengths_nm);
    const std::size_t layer = random() % it.stack.layers.size();
    it.stack.layers[layer].thickness_nm = random.uniform(0, 1000);
    const auto there = stack_powers<lanes>(StackTable(it.stack, it.wavelengths_nm), 0, {.cos_i = it.cos_i});
    const auto here = stack_powers<lanes>(
        before, 0, {.cos_i = it.cos_i, .layer = layer, .thickness_nm = it.stack.layers[layer].thickness_nm});
    for (int i = 0; i < lanes; ++i) EXPECT_EQ(here.R_s[i], there.R_s[i]);
  }
}

// Any number of wavelengths: a row ends at a multiple of 16.
TEST(PacketStack, RowsHoldEveryWavelength) {
  Stack stack;
  stack.layers.push_back({Medium::constant(as_float(1.4)), 300, true});
  std::vector<double> wavelengths_nm;
  for (int nm = 360; nm <= 830; ++nm) wavelengths_nm.push_back(nm);
  const StackTable table(stack, wavelengths_nm);
  ASSERT_EQ(table.row_size, 480u);
  for (std::size_t first = 0; first < table.row_size; first += lanes) {
    const auto fast = stack_powers<lanes>(table, first, {.cos_i = 0.8});
    for (int i = 0; i < lanes; ++i) {
      const double nm = wavelengths_nm[std::min(first + static_cast<std::size_t>(i), table.wavelength_count - 1)];
      const Amplitudes exact = stack_amplitudes(resolve(stack, nm), incidence_from_cos(0.8), nm);
      EXPECT_NEAR(fast.R_s[i], norm(exact.r_s), 1e-6);
    }
  }
}

// Thousands of layers, metres of metal, layers of no thickness, rays along the stack and at a critical angle.
TEST(PacketStack, Limits) {
  const Medium high = Medium::constant(as_float(2.4)), low = Medium::constant(as_float(1.4));
  const Medium silver = Medium::constant({as_float(0.05), as_float(3.3)}), glass = Medium::constant(as_float(1.5));
  Stack mirror, metal, nothing, gap;
  for (int j = 0; j < 4000; ++j) mirror.layers.push_back({j % 2 ? low : high, 80, true});
  metal.layers = {{low, 100, true}, {silver, 1e9, true}, {low, 100, true}};
  nothing.layers = {{high, 0, true}, {silver, 0, true}};
  gap.incidence = gap.exit = glass;
  gap.layers = {{Medium::constant(1.0), 100, true}};
  Errors errors;
  for (const Stack& stack : {mirror, metal, nothing, gap})
    for (const double cos_i : {1.0, 0.5, 1e-3, 1e-6, as_float(std::sqrt(1 - 1 / (1.5 * 1.5)))})
      compare(case_of(stack, cos_i), errors);
  // Exactly at the critical angle, for the float closest to it, and along the stack.
  for (const double cos_i : {std::sqrt(1 - 1 / 2.25), 0.0}) {
    const StackCase it = case_of(gap, cos_i);
    const auto fast = stack_powers<lanes>(StackTable(gap, it.wavelengths_nm), 0, {.cos_i = cos_i});
    for (int i = 0; i < lanes; ++i) EXPECT_NEAR(fast.R_s[i] + fast.T_s[i], 1, kept_energy);
  }
  errors.expect();
}

// The cosine of the critical angle as the renderer's tables compute it: for some pairs of indices q^2 there is 0, for
// others a rounding error of either sign. Into a thinner medium, and through a layer of it.
TEST(PacketStack, IsFiniteAtEveryCriticalAngle) {
  const auto check = [](const Stack& stack, double ratio) {
    const double critical = std::sqrt(1 - 1 / (ratio * ratio));
    for (const double cos_i : {critical, std::nextafter(critical, 0), std::nextafter(critical, 1)}) {
      const StackCase it = case_of(stack, cos_i);
      const auto fast = stack_powers<lanes>(StackTable(stack, it.wavelengths_nm), 0, {.cos_i = cos_i});
      for (int i = 0; i < lanes; ++i) {
        ASSERT_NEAR(fast.R_s[i] + fast.T_s[i], 1, 2e-5) << ratio << ' ' << cos_i;
        ASSERT_NEAR(fast.R_p[i] + fast.T_p[i], 1, 2e-5) << ratio << ' ' << cos_i;
      }
    }
  };
  for (int far = 100; far <= 200; far += 10)
    for (int near = far + 1; near <= 260; ++near) {
      Stack bare, layered;
      bare.incidence = Medium::constant(near / 100.0), bare.exit = Medium::constant(far / 100.0);
      layered.incidence = layered.exit = bare.incidence;
      layered.layers = {{bare.exit, 100, true}};
      check(bare, (near / 100.0) / (far / 100.0));
      check(layered, (near / 100.0) / (far / 100.0));
    }
}

}  // namespace
}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
