// Coherent stacks of any number of layers for many wavelengths at once: (29) to (32). The algebra runs in float, and
// where the stack is so selective that float's rounding would show, in double: what decides is the light inside the
// stack (docs/decisions/0006).
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "shabon/optics/packet/free_film.h"
#include "shabon/optics/packet/stack_layers.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

inline constexpr std::size_t no_layer = std::numeric_limits<std::size_t>::max();

// From where the light comes, and the thickness of one layer where it is not the table's.
struct StackRay {
  double cos_i = 1;              // in medium 1, 0..1; kept above 1e-8
  bool from_exit = false;        // the light comes from the exit side; only where the outer media are equal
  std::size_t layer = no_layer;  // whose thickness is
  double thickness_nm = 0;       // this
  // (n1 cos)^2 at each of the N wavelengths where medium 1 is itself inside of something and its angle depends on the
  // wavelength; then cos_i is the least of them.
  const double* q1_squared = nullptr;
};

// The same ray for the wavelengths from the given one on.
inline StackRay from_wavelength(StackRay at, std::size_t skipped) {
  if (at.q1_squared != nullptr) at.q1_squared += skipped;
  return at;
}

// What comes out at the near face for N wavelengths of one polarisation, before any division: r = difference/sum,
// t = 2 u1 passed/sum, with u1 and u3 of the outer media.
template <class T, int N>
struct StackSide {
  math::complex_packet<T, N> difference, sum;  // u1 E - H, u1 E + H
  math::packet<T, N> u1;
  math::complex_packet<T, N> u3;
  math::packet<T, N> passed;    // what all scalings multiply up to
  math::packet<T, N> rounding;  // of Fields, scaled as size^2 is
};

template <class T, int N>
struct StackSides {
  StackSide<T, N> s, p;
  bool lossless;  // layers and exit medium, with light running on into it at every wavelength
};

template <class T, int N>
inline RayLanes<N> ray_lanes(const StackTable& table, std::size_t first, const StackRay& at) {
  const double cos2 = std::max(at.cos_i * at.cos_i, least_cos2);
  const auto n1_squared = row_at<N>(table.incidence.in_double.n_squared, first);
  const auto q1_squared = at.q1_squared == nullptr
                              ? n1_squared * cos2
                              : max(math::packet<double, N>::load(at.q1_squared), n1_squared * least_cos2);
  return {first, cos2, q1_squared, row_at<N>(table.half_turns_per_nm, first)};
}

// The fields at the exit: a wave that runs away alone, E = 1 and H = u3.
template <class T, int N>
inline void begin_at_exit(const StackTable& table, const RayLanes<N>& ray, bool running, StackSides<T, N>& sides,
                          StackWave<T, N>& wave) {
  using P = math::packet<T, N>;
  using C = math::complex_packet<T, N>;
  const SquaredRows<T>&n1 = table.incidence.squared<T>(), &n3 = table.exit.squared<T>();
  const P q1_squared = math::convert<T>(ray.q1_squared);
  sides.s.u1 = q1_squared * math::reciprocal_sqrt(q1_squared);
  sides.p.u1 = sides.s.u1 * row_at<N>(n1.inverse, ray.first);
  if (running) {
    const P q3_squared = math::convert<T>(row_at<N>(table.exit.step, ray.first) + ray.q1_squared);
    const P q3 = q3_squared * math::reciprocal_sqrt(q3_squared);
    sides.s.u3 = C(q3), sides.p.u3 = C(q3 * row_at<N>(n3.inverse, ray.first));
  } else {
    sides.s.u3 = ComplexRoots<T, N>(q_squared_of<T, N>(table.exit, ray)).q;
    sides.p.u3 = sides.s.u3 * row_pair<T, N>(n3.inverse, n3.inverse_im, table.exit.lossless, ray.first);
  }
  const auto running_away = [](const C& u3) { return Fields<T, N>{C(P(T(1))), C(-u3.im, u3.re)}; };
  wave.s = running_away(sides.s.u3), wave.p = running_away(sides.p.u3);
}

// Brings the fields back to the order of 1, before squares of them can overflow.
template <class T, int N>
inline void rescale(Fields<T, N>& f, StackSide<T, N>& side) {
  const auto scale = math::reciprocal(abs(f.e.re) + abs(f.e.im) + abs(f.ih.re) + abs(f.ih.im));
  f.e = {f.e.re * scale, f.e.im * scale}, f.ih = {f.ih.re * scale, f.ih.im * scale};
  side.passed *= scale;
  const auto scale2 = scale * scale;
  f.size *= scale2, f.rounding *= scale2 * scale2;
}

template <class T, int N>
inline void end_at_entrance(const Fields<T, N>& f, StackSide<T, N>& side) {
  const math::complex_packet<T, N> u1_e(side.u1 * f.e.re, side.u1 * f.e.im), h(f.ih.im, -f.ih.re);
  side.difference = u1_e - h;
  side.sum = u1_e + h;
  side.rounding = f.rounding;
}

// The wavelengths first..first+N of the table's rows; `first` is a multiple of N.
template <class T, int N>
inline StackSides<T, N> cross_stack(const StackTable& table, std::size_t first, const StackRay& at) {
  using P = math::packet<T, N>;
  constexpr std::size_t layers_between_scalings = 8;
  const RayLanes<N> ray = ray_lanes<T, N>(table, first, at);
  const bool running =
      table.exit.lossless && table.exit.least_step + table.least_n1_squared * ray.cos2 > least_q_squared;
  StackSides<T, N> sides;
  sides.lossless = table.lossless && running;
  sides.s.passed = sides.p.passed = P(T(1));
  StackWave<T, N> wave;
  begin_at_exit(table, ray, running, sides, wave);
  const std::size_t count = table.layers.size();
  for (std::size_t met = 0; met < count; ++met) {
    const std::size_t j = at.from_exit ? met : count - 1 - met;
    const LayerOfTable& layer = table.layers[j];
    cross_layer<T, N>(table, table.media[layer.medium], ray, j == at.layer ? at.thickness_nm : layer.thickness_nm,
                      wave);
    if (met % layers_between_scalings == layers_between_scalings - 1)
      rescale(wave.s, sides.s), rescale(wave.p, sides.p);
  }
  end_at_entrance(wave.s, sides.s), end_at_entrance(wave.p, sides.p);
  if (any(wave.faded > P(T(0)))) {
    const P decay = math::exp2(-wave.faded);
    sides.s.passed *= decay, sides.p.passed *= decay;
  }
  return sides;
}

// 4 u1 Re(u3) passed^2: what runs on, in units of |sum|^2.
template <class T, int N>
inline math::packet<T, N> outgoing(const StackSide<T, N>& side) {
  return T(4) * side.u1 * side.u3.re * (side.passed * side.passed);
}

// R and T of one polarisation. Without loss |sum|^2 - |difference|^2 = 4 u1 u3 passed^2, so that R + T = 1 to rounding.
template <class T, int N>
inline std::array<math::packet<T, N>, 2> powers_of(const StackSide<T, N>& side, bool lossless) {
  const auto out = outgoing(side), back = norm(side.difference);
  const auto over = math::reciprocal(lossless ? back + out : norm(side.sum));
  return {back * over, out * over};
}

// r, and t as the ratio of E (s) or of the magnetic field (p). The sign of t is that of both polarisations or neither.
template <class T, int N>
struct SideAmplitudes {
  math::complex_packet<T, N> r, t;
};

template <class T, int N>
inline SideAmplitudes<T, N> amplitudes_of(const StackSide<T, N>& side, bool lossless) {
  auto over = math::reciprocal(norm(side.sum));
  if (lossless) {  // to first order, so that |r|^2 and |t|^2 are the R and T of powers_of
    const auto exact = math::reciprocal(norm(side.difference) + outgoing(side));
    over = exact * (T(1.5) - T(0.5) * (norm(side.sum) * exact));
  }
  const math::complex_packet<T, N> over_sum(side.sum.re * over, -(side.sum.im * over));
  const auto factor = T(2) * side.u1 * side.passed;
  return {side.difference * over_sum, {factor * over_sum.re, factor * over_sum.im}};
}

// The square root of the sum of squares, over all faces, of the light there in shares of what falls on the stack (and
// of what opaque layers cancel): R and T in float are wrong by up to about 1e-7 times this.
template <class T, int N>
inline math::packet<T, N> light_inside(const StackSide<T, N>& side) {
  return T(2) * side.u1 * sqrt(side.rounding) * math::reciprocal(norm(side.sum));
}

// Above this, float's rounding may exceed 5e-6 in R or T.
inline constexpr float most_light_inside = 12;

// With more layers float would be in vain too often: a packet in double takes at most half as long again.
inline constexpr std::size_t most_layers_in_float = 8;

template <int N>
inline bool needs_double(const StackSides<float, N>& sides) {
  const math::packet<float, N> most(most_light_inside);
  // Written so that not-a-number, from an overflow, needs double too.
  const auto fine = (light_inside(sides.s) <= most) & (light_inside(sides.p) <= most);
  return bits(fine) != (1u << N) - 1;
}

// Packets of N from those of both halves.
template <int N, class Halves>
inline auto joined_halves(const Halves& low, const Halves& high) {
  using T = std::remove_cvref_t<decltype(low[0][0])>;
  std::array<math::packet<T, N>, std::tuple_size_v<Halves>> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = {low[i], high[i]};
  return result;
}

// finish(StackSides<T, M>) -> std::array of packets<T, M>, as packets of N; for registers M at a time.
template <class T, int N, class Finish>
inline auto in_lanes_of(const StackTable& table, std::size_t first, const StackRay& at, const Finish& finish) {
  if constexpr (!math::fits_register<T, N>)
    return joined_halves<N>(in_lanes_of<T, N / 2>(table, first, at, finish),
                            in_lanes_of<T, N / 2>(table, first + N / 2, from_wavelength(at, N / 2), finish));
  else
    return finish(cross_stack<T, N>(table, first, at));
}

// The same as packets of float, in the precision that the stack needs.
template <int N, class Finish>
inline auto with_enough_digits(const StackTable& table, std::size_t first, const StackRay& at, const Finish& finish) {
  if constexpr (!math::fits_register<float, N>) {
    return joined_halves<N>(with_enough_digits<N / 2>(table, first, at, finish),
                            with_enough_digits<N / 2>(table, first + N / 2, from_wavelength(at, N / 2), finish));
  } else {
    decltype(finish(std::declval<StackSides<float, N>>())) result;
    if (table.layers.size() <= most_layers_in_float) [[likely]] {
      const StackSides<float, N> sides = cross_stack<float, N>(table, first, at);
      result = finish(sides);
      if (!needs_double(sides)) [[likely]]
        return result;
    }
    const auto exact = in_lanes_of<double, N>(table, first, at, finish);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = math::convert<float>(exact[i]);
    return result;
  }
}

// R and T of s and p within 5e-6 for wavelengths first..first+N of the table; `first` is a multiple of N.
template <int N>
inline FilmPowers<N> stack_powers(const StackTable& table, std::size_t first, const StackRay& at) {
  const auto x = with_enough_digits<N>(table, first, at, [](const auto& sides) {
    const auto s = powers_of(sides.s, sides.lossless), p = powers_of(sides.p, sides.lossless);
    return std::array{s[0], p[0], s[1], p[1]};
  });
  return {x[0], x[1], x[2], x[3]};
}

// One block (16) from the powers and from x_s conj(x_p).
template <class T, int N>
inline std::array<math::packet<T, N>, 4> mueller_block(const math::packet<T, N>& s, const math::packet<T, N>& p,
                                                       const math::complex_packet<T, N>& both) {
  return {T(0.5) * (s + p), T(0.5) * (s - p), both.re, both.im};
}

// t relates E (s) and the magnetic field (p); between unequal media the power that runs on has another factor for each.
template <class T, int N>
inline math::packet<T, N> outer_media_factor(const StackSides<T, N>& sides) {
  const auto ratio = (sides.s.u3.re * sides.p.u3.re) / (sides.s.u1 * sides.p.u1);
  return sqrt(max(ratio, math::packet<T, N>(T(0))));
}

struct MuellerOfSides {
  bool equal_outer_media;

  template <class T, int N>
  std::array<math::packet<T, N>, 8> operator()(const StackSides<T, N>& sides) const {
    const auto s = powers_of(sides.s, sides.lossless), p = powers_of(sides.p, sides.lossless);
    const auto in_s = amplitudes_of(sides.s, sides.lossless), in_p = amplitudes_of(sides.p, sides.lossless);
    const auto r = mueller_block(s[0], p[0], in_s.r * conj(in_p.r));
    auto passed = in_s.t * conj(in_p.t);
    if (!equal_outer_media) {
      const auto factor = outer_media_factor(sides);
      passed = {passed.re * factor, passed.im * factor};
    }
    const auto t = mueller_block(s[1], p[1], passed);
    return {r[0], r[1], r[2], r[3], t[0], t[1], t[2], t[3]};
  }
};

// Both Mueller blocks within 5e-6: r from the side of medium 1 (of the exit with from_exit), and t, which is the same
// from both sides.
template <int N>
inline FilmMueller<N> stack_mueller(const StackTable& table, std::size_t first, const StackRay& at) {
  const auto x = with_enough_digits<N>(table, first, at, MuellerOfSides{table.equal_outer_media});
  return {{x[0], x[1], x[2], x[3]}, {x[4], x[5], x[6], x[7]}};
}

// The same in double.
template <int N>
inline FilmMueller<N, double> exact_stack_mueller(const StackTable& table, std::size_t first, const StackRay& at) {
  const auto x = in_lanes_of<double, N>(table, first, at, MuellerOfSides{table.equal_outer_media});
  return {{x[0], x[1], x[2], x[3]}, {x[4], x[5], x[6], x[7]}};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
