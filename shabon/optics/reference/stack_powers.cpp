// Incoherent layers cut a stack into blocks of coherent ones. Within a block fields add (29)-(34), between blocks
// intensities (35), (36); a coherent stack is a single block.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/layer_fields.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

// One polarisation of a stack at one angle and wavelength.
struct PolarisedLayer {
  Complex u;
  Crossing crossing;
  bool coherent;
  bool takes_nothing;
};

struct PolarisedStack {
  Complex u1;
  std::vector<PolarisedLayer> layers;
  Complex u3;
  bool lossless_incidence;

  // Of the medium behind the layers before `layer`.
  Complex u_before(std::size_t layer) const { return layer == 0 ? u1 : layers[layer - 1].u; }
  Complex u_at(std::size_t layer) const { return layer == layers.size() ? u3 : layers[layer].u; }
};

std::array<PolarisedStack, 2> polarised(const ResolvedStack& stack, Incidence incidence, double wavelength_nm) {
  const FieldRatios u1 = field_ratios(stack.n1, stack.n1 * incidence.cos_i);
  const FieldRatios u3 = field_ratios(stack.n3, normal_index(stack.n1, incidence, stack.n3));
  const bool lossless_incidence = stack.n1.imag() == 0;
  std::array<PolarisedStack, 2> both = {{{u1.s, {}, u3.s, lossless_incidence}, {u1.p, {}, u3.p, lossless_incidence}}};
  for (PolarisedStack& one : both) one.layers.reserve(stack.layers.size());
  for (const ResolvedLayer& layer : stack.layers) {
    const PlaneLayer at =
        (layer.coherent ? plane_layer : thick_layer)(stack.n1, incidence, layer.n, layer.thickness_nm, wavelength_nm);
    // Heat is Im n^2 times |E|^2. Behind an absorbing first medium fields decay sideways as well, and flux goes there.
    const bool takes_nothing = lossless_incidence && (layer.n.imag() == 0 || layer.n.real() == 0);
    both[0].layers.push_back({at.u.s, crossing_s(at), layer.coherent, takes_nothing});
    both[1].layers.push_back({at.u.p, crossing_p(at), layer.coherent, takes_nothing});
  }
  return both;
}

// A block as light from one side meets it, for an incident wave of |F|^2 = 1.
struct Look {
  double reflected = 0;      // |r|^2
  double not_reflected = 1;  // 1 - |r|^2, without the subtraction
  double transmitted = 1;    // |t|^2
  double flux = 0;           // (33) at the face that light meets
};

// Coherent layers first..last-1, between an incoherent layer or a half-space on either side.
struct Block {
  std::size_t first, last;
  Look front, back;
};

enum class From { front, back };

// Fills absorbed[m] for the layers m of the block: what each takes, as flux (34). `factors` is scratch of that size.
Look look(const PolarisedStack& stack, const Block& block, From from, std::vector<double>& absorbed,
          std::vector<double>& factors) {
  const std::size_t count = block.last - block.first;
  const auto nth = [&](std::size_t i) { return from == From::front ? block.first + i : block.last - 1 - i; };
  const Complex u_front = stack.u_before(block.first), u_back = stack.u_at(block.last);
  const Complex u_near = from == From::front ? u_front : u_back, u_far = from == From::front ? u_back : u_front;

  TangentialFields fields{1, u_far};
  for (std::size_t i = count; i-- > 0;) {
    const std::size_t m = nth(i);
    const double flux_out = fields.flux();
    factors[m] = cross(fields, stack.layers[m].crossing);
    const double taken = fields.flux() - factors[m] * factors[m] * flux_out;
    absorbed[m] = stack.layers[m].takes_nothing ? 0 : stack.lossless_incidence ? std::max(0.0, taken) : taken;
  }
  // As in (32); without an incident wave of its own only at 90 degrees with nothing between equal media. Quotients
  // first: the squares of very small fields are 0.
  const Complex twice_incident = u_near * fields.F + fields.G;
  const bool nothing_there = twice_incident == 0.0;
  Look seen;
  if (!nothing_there) {
    const Complex F = u_near * fields.F / twice_incident, G = fields.G / twice_incident;
    seen.reflected = norm(F - G);
    seen.not_reflected = 4 * real(F * conj(G));
    seen.flux = 4 * real(F * conj(G * u_near));
  }
  double per_incident = nothing_there ? 1 / norm(fields.F) : 4 * norm(u_near / twice_incident);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t m = nth(i);
    absorbed[m] *= per_incident;
    per_incident *= factors[m] * factors[m];
  }
  seen.transmitted = per_incident;
  return seen;
}

// a of (35).
double passes_once(const PolarisedLayer& incoherent) { return incoherent.crossing.decay * incoherent.crossing.decay; }

// A block together with all that lies behind it.
struct Rest {
  double reflected, not_reflected;
  double ends;         // Z: of the light in the layer behind the block, what does not come by again
  double returned;     // a^2 R: what comes back to the block's back face, of what left it
  bool total = false;  // intensities do not add up here: taken as total reflection
};

constexpr double never = std::numeric_limits<double>::infinity();  // light enters the layer and comes by again: Z

constexpr Rest total_reflection = {1, 0, never, 0, true};

// Nothing comes back through the layer behind the block.
Rest ends_there(const Block& block) { return {block.front.reflected, block.front.not_reflected, never, 0}; }

// Whether waves in an incoherent layer take power along: not if they only decay.
bool carries_power(const PolarisedLayer& incoherent) {
  return incoherent.u.imag() <= 0 || incoherent.u.real() > std::numeric_limits<double>::epsilon() * incoherent.u.imag();
}

// (35).
Rest rest_behind(const Block& block, const PolarisedLayer& layer, const Rest& next, bool lossless_before) {
  if (!carries_power(layer)) return ends_there(block);
  const double passes_twice = passes_once(layer) * passes_once(layer);
  const double returned = passes_twice * next.reflected;
  const double not_returned =  // 1 - a^2 R, without the subtraction where that matters
      returned < 0.5 ? 1 - returned : next.not_reflected + next.reflected * (1 - passes_twice);
  const double ends = block.back.not_reflected + block.back.reflected * not_returned;
  if (ends <= 0) return lossless_before ? total_reflection : ends_there(block);
  const double there_and_back = block.front.transmitted * block.back.transmitted;
  const double reflected = block.front.reflected + there_and_back * returned / ends;
  if (lossless_before && reflected > 1) return total_reflection;
  const double not_reflected = (block.front.not_reflected * block.back.not_reflected - there_and_back +
                                not_returned * (block.front.not_reflected * block.back.reflected + there_and_back)) /
                               ends;
  return {reflected, not_reflected, ends, returned};
}

// Every block with what lies behind it, from the incidence side.
struct Blocks {
  std::vector<Block> blocks;
  std::vector<Rest> rests;
  std::vector<double> absorbed_front, absorbed_back;  // per layer, of light from that side of its block
};

Blocks blocks_of(const PolarisedStack& stack) {
  const std::size_t count = stack.layers.size();
  Blocks all{{}, {}, std::vector<double>(count), std::vector<double>(count)};
  std::vector<double> factors(count);
  for (std::size_t first = 0, last = 0; last <= count; first = ++last) {
    while (last < count && stack.layers[last].coherent) ++last;
    Block block{first, last, {}, {}};
    block.front = look(stack, block, From::front, all.absorbed_front, factors);
    if (last < count) block.back = look(stack, block, From::back, all.absorbed_back, factors);
    all.blocks.push_back(block);
  }
  const Look& last = all.blocks.back().front;
  all.rests.resize(all.blocks.size(), {last.reflected, last.not_reflected, 1, 0});
  for (std::size_t k = all.blocks.size() - 1; k-- > 0;) {
    const Block& block = all.blocks[k];
    const bool lossless = block.first == 0 ? stack.lossless_incidence : stack.layers[block.first - 1].takes_nothing;
    all.rests[k] = rest_behind(block, stack.layers[block.last], all.rests[k + 1], lossless);
  }
  return all;
}

struct OnePolarisation {
  double R = 0, T = 0;
  std::vector<double> A;
};

// (36): forwards again, with what arrives at each block from the front and from the back.
OnePolarisation shares(const PolarisedStack& stack, bool grazing) {
  const Blocks all = blocks_of(stack);
  OnePolarisation answer{all.rests[0].reflected, 0, std::vector<double>(stack.layers.size())};
  const double per_incident = grazing ? 0 : 1 / real(stack.u1);
  double forward = 1, flux_before = 0;
  for (std::size_t k = 0; k < all.blocks.size(); ++k) {
    const Block& block = all.blocks[k];
    const bool held = all.rests[k].total;
    const double leaves = forward * block.front.transmitted;
    const double entered = leaves / all.rests[k].ends;
    const double backward = entered * all.rests[k].returned;
    if (block.first > 0) {
      const PolarisedLayer& layer = stack.layers[block.first - 1];
      const double flux_in = held ? 0 : forward * block.front.flux - backward * block.back.transmitted * real(layer.u);
      const double taken = layer.takes_nothing ? 0 : flux_before - flux_in;
      answer.A[block.first - 1] = taken * per_incident;
    }
    if (held) break;
    for (std::size_t m = block.first; m < block.last; ++m)
      answer.A[m] = (forward * all.absorbed_front[m] + backward * all.absorbed_back[m]) * per_incident;
    if (block.last == stack.layers.size()) {
      answer.T = leaves * (grazing ? 1 : real(stack.u3) / real(stack.u1));
      break;
    }
    flux_before = leaves * real(stack.u_at(block.last)) - backward * block.back.flux;
    forward = entered * passes_once(stack.layers[block.last]);
  }
  return answer;
}

// Where no power can travel in an incoherent layer, or a wave decays in it within a wavelength, its waves' intensities
// do not add up to the power; energy is kept here.
void hold_to_energy(OnePolarisation& answer) {
  if (answer.R + answer.T < 1) return;
  answer.R = std::min(answer.R, 1.0);
  answer.T = std::min(answer.T, 1 - answer.R);
  std::fill(answer.A.begin(), answer.A.end(), 0.0);
}

}  // namespace

StackPowers stack_powers(const ResolvedStack& stack, Incidence incidence, double wavelength_nm) {
  const auto [polarised_s, polarised_p] = polarised(stack, incidence, wavelength_nm);
  OnePolarisation s = shares(polarised_s, incidence.cos_i == 0), p = shares(polarised_p, incidence.cos_i == 0);
  const bool mixed = std::any_of(stack.layers.begin(), stack.layers.end(), [](auto& layer) { return !layer.coherent; });
  if (mixed && polarised_s.lossless_incidence) {
    hold_to_energy(s);
    hold_to_energy(p);
  }
  return {{s.R, p.R, s.T, p.T}, std::move(s.A), std::move(p.A)};
}

StackPowers stack_powers(const Stack& stack, Incidence incidence, double wavelength_nm) {
  return stack_powers(resolve(stack, wavelength_nm), incidence, wavelength_nm);
}

}  // namespace shabon::optics
