#include "shabon/render/kernel/scattering/pane_table.h"

#include <numbers>

#include "shabon/optics/reference/stack.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

constexpr double log2_e = std::numbers::log2e;

// One of the three numbers per wavelength that add up over the passes: the power of s, of p, or s times conj(p).
using Term = math::complex_packet<float, lane_count>;

struct Terms {
  Term s, p, both;
};

Terms terms_of(const optics::MuellerBlock<lane_count>& m) { return {{m.a + m.b}, {m.a - m.b}, {m.c, m.d}}; }

optics::MuellerBlock<lane_count> block_of(const Terms& t) {
  const Lanes half(0.5f);
  return {half * (t.s.re + t.p.re), half * (t.s.re - t.p.re), t.both.re, t.both.im};
}

Term scaled(const Term& term, const Lanes& factor) { return {term.re * factor, term.im * factor}; }
}  // namespace

PaneTable::PaneTable(const optics::Stack& stack, const std::vector<Comb>& combs) {
  std::vector<double> wavelengths_nm;
  for (const Comb& comb : combs)
    wavelengths_nm.insert(wavelengths_nm.end(), comb.wavelength_nm.begin(), comb.wavelength_nm.end());
  const auto ratios = [&](const optics::Medium& medium) {
    std::vector<LanesD> result;
    for (const Comb& comb : combs) {
      double ratio[lane_count];
      for (int i = 0; i < lane_count; ++i)
        ratio[i] = stack.incidence.index(comb.wavelength_nm[i]).real() / medium.index(comb.wavelength_nm[i]).real();
      result.push_back(LanesD::load(ratio));
    }
    return result;
  };
  optics::Stack group{stack.incidence, {}, stack.exit};
  const auto close_group = [&](const optics::Medium& behind) {
    group.exit = behind;
    groups_.push_back(
        {optics::StackTable(group, wavelengths_nm), optics::StackTable(optics::reversed(group), wavelengths_nm)});
  };
  for (const optics::Layer& layer : stack.layers) {
    if (layer.coherent) {
      group.layers.push_back(layer);
      continue;
    }
    const optics::Medium clear = layer.medium.without_absorption();  // it only fades light behind the boundary
    close_group(clear);
    Slab slab{layer.thickness_nm, {}, ratios(clear), !layer.medium.is_lossless()};
    for (const Comb& comb : combs) {
      double loss[lane_count];
      for (int i = 0; i < lane_count; ++i) {
        const double nm = comb.wavelength_nm[i];
        loss[i] = 4 * std::numbers::pi * log2_e * layer.medium.index(nm).imag() / nm;
      }
      slab.log2_loss_per_nm.push_back(math::convert<float>(LanesD::load(loss)));
    }
    slabs_.push_back(std::move(slab));
    group = {clear, {}, stack.exit};
  }
  close_group(stack.exit);
}

namespace {

// What one group does, and the squared cosine in the medium before it.
struct GroupAt {
  Terms reflected, transmitted;
  LanesD cos_squared;
};

// `ratio` is the outside's index over that of the medium before the group; the light runs at sin^2 outside.
GroupAt look_at(const optics::StackTable& table, std::size_t first, const LanesD& ratio, double sin2) {
  GroupAt result;
  result.cos_squared = max(LanesD(1.0) - ratio * ratio * sin2, LanesD(0.0));
  alignas(64) double q1_squared[lane_count];
  (result.cos_squared * LanesD::load(&table.incidence.in_double.n_squared[first])).store(q1_squared);
  double least = 1;
  for (int i = 0; i < lane_count; ++i) least = std::min(least, result.cos_squared[i]);
  const optics::StackRay ray{.cos_i = std::sqrt(least), .q1_squared = q1_squared};
  const auto m = optics::stack_mueller<lane_count>(table, first, ray);
  result.reflected = terms_of(m.reflected), result.transmitted = terms_of(m.transmitted);
  return result;
}

}  // namespace

// From the last group to the first: what the pane does from each on, seen from the medium in front of it.
optics::FilmMueller<lane_count> PaneTable::at(std::size_t comb, double cos_i, bool from_back) const {
  const std::size_t first = comb * lane_count, last = groups_.size() - 1;
  const double sin2 = std::max(0.0, 1 - cos_i * cos_i);
  const auto group = [&](std::size_t k) -> const Group& { return groups_[from_back ? last - k : k]; };
  const auto slab_behind = [&](std::size_t k) -> const Slab& { return slabs_[from_back ? last - 1 - k : k]; };
  const auto ratio_before = [&](std::size_t k) { return k == 0 ? LanesD(1.0) : slab_behind(k - 1).index_ratio[comb]; };
  const auto from_front = [&](std::size_t k) {
    return look_at(from_back ? group(k).backward : group(k).forward, first, ratio_before(k), sin2);
  };
  const GroupAt end = from_front(last);
  Terms reflected = end.reflected, transmitted = end.transmitted;
  for (std::size_t k = last; k-- > 0;) {
    const Slab& slab = slab_behind(k);
    const GroupAt here = from_front(k);
    const GroupAt behind =
        look_at(from_back ? group(k).forward : group(k).backward, first, slab.index_ratio[comb], sin2);
    Lanes passed(1.0f);
    if (slab.absorbs) {
      const Lanes cosine = math::convert<float>(sqrt(max(behind.cos_squared, LanesD(1e-12))));
      passed = math::exp2(-(slab.log2_loss_per_nm[comb] * Lanes(static_cast<float>(slab.thickness_nm)) / cosine));
    }
    const Term one{Lanes(1.0f + 2e-7f)};  // at grazing incidence nothing enters and nothing leaves
    const auto add_passes = [&](const Term& r, const Term& t, const Term& r_back, Term& R, Term& T) {
      const Term below = scaled(R, passed * passed), all = one / (one - r_back * below);
      T = t * scaled(T, passed) * all;
      R = r + t * t * below * all;
    };
    add_passes(here.reflected.s, here.transmitted.s, behind.reflected.s, reflected.s, transmitted.s);
    add_passes(here.reflected.p, here.transmitted.p, behind.reflected.p, reflected.p, transmitted.p);
    add_passes(here.reflected.both, here.transmitted.both, behind.reflected.both, reflected.both, transmitted.both);
  }
  return {block_of(reflected), block_of(transmitted)};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
