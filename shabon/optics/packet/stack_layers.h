// How one layer of a stack carries the tangential fields from its far face to its near one, for N wavelengths at once:
// the characteristic matrix (30) applied to a vector. From the exit side on that is stable for layers of any kind: what
// grows numerically is what grows in nature, and opaque layers are scaled by e^(-Im beta).
//
// The vector is (E, iH) with H in units of E; then a lossless layer with a real angle is a real matrix,
//   E' = cos(beta) E - sin(beta)/u iH,  iH' = sin(beta) u E + cos(beta) iH,
// eight real products for a complex vector. u = q for s, q/n^2 for p (then E stands for the magnetic field),
// q = n cos(theta). T is the algebra's number type; q^2 and the phase are formed in double for any T.
#pragma once

#include <numbers>

#include "shabon/math/packet_complex.h"
#include "shabon/math/packet_convert.h"
#include "shabon/math/packet_math.h"
#include "shabon/optics/packet/stack_table.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

// The fields of one polarisation at a face; in float also what the rounding so far will do, see rounding_of.
template <class T, int N>
struct Fields {
  math::complex_packet<T, N> e, ih;
  math::packet<T, N> size{T(0)};      // |E|^2 + |H|^2
  math::packet<T, N> rounding{T(0)};  // the sum over the faces behind, scaled as size^2 is
};

// Both polarisations on their way from the exit to the entrance.
template <class T, int N>
struct StackWave {
  Fields<T, N> s, p;
  math::packet<T, N> faded{T(0)};  // log2 of what the scaling of opaque layers took away
};

// What all layers of a stack share in one evaluation.
template <int N>
struct RayLanes {
  std::size_t first;                          // of the wavelengths in the table's rows
  double cos2;                                // of the angle in medium 1, positive
  math::packet<double, N> q1_squared;         // (n1 cos)^2
  math::packet<double, N> half_turns_per_nm;  // 2/wavelength
};

template <int N, class T>
inline math::packet<T, N> row_at(const WavelengthRow<T>& row, std::size_t first) {
  return math::packet<T, N>::load(&row[first]);
}

// The sine and cosine of the phase's real part, both with the sign (-1)^whole left out: the same for s and p.
template <class T, int N>
struct Turn {
  math::packet<T, N> sine, cosine;
};

template <class T, int N>
inline Turn<T, N> turn_of(const math::packet<double, N>& half_turns) {
  const auto x = math::convert<T>(half_turns - math::round(half_turns));
  return {math::sin_pi_reduced(x), math::cos_pi_reduced(x)};
}

// sin(beta)/u and sin(beta) u, either all real or all complex.
template <class Number>
struct LayerMatrix {
  Number cosine, over, times;
};

template <class T, int N>
inline math::packet<T, N> size_of(const Fields<T, N>& f) {
  return norm(f.e) + norm(f.ih);
}

// The rounding of one layer's matrix, some 1e-7 of the fields on both of its sides, reaches r as 1e-7 times their
// product over what falls on the stack; roundings of several layers add up as squares do. Behind an opaque layer the
// fields may be far larger than in front of it: then digits are lost in it.
template <class T, int N>
inline void count_rounding(Fields<T, N>& f) {
  if constexpr (sizeof(T) == 4) {
    const math::packet<T, N> behind = f.size;
    f.size = size_of(f);
    f.rounding += f.size * (f.size + T(0.25) * behind);
  }
}

template <class T, int N, class Number>
inline void cross(Fields<T, N>& f, const LayerMatrix<Number>& m) {
  if constexpr (std::is_same_v<Number, math::packet<T, N>>) {
    const math::complex_packet<T, N> e = f.e;
    f.e = {m.cosine * e.re - m.over * f.ih.re, m.cosine * e.im - m.over * f.ih.im};
    f.ih = {m.cosine * f.ih.re + m.times * e.re, m.cosine * f.ih.im + m.times * e.im};
  } else {
    const math::complex_packet<T, N> e = m.cosine * f.e - m.over * f.ih;
    f.ih = m.cosine * f.ih + m.times * f.e;
    f.e = e;
  }
  count_rounding(f);
}

// The square root of q^2 and its reciprocal in T, and the root with double's digits for the phase.
template <class T, int N>
struct Roots {
  math::packet<T, N> q, over_q;
  math::packet<double, N> exact;

  explicit Roots(const math::packet<double, N>& q_squared) {
    const auto squared = math::convert<T>(q_squared);
    over_q = math::reciprocal_sqrt(squared);
    q = squared * over_q;
    if constexpr (sizeof(T) == 8) {
      exact = q;
    } else {  // one step of Newton's method
      const auto rough = math::convert<double>(q), half_over = math::convert<double>(over_q * T(0.5));
      exact = rough + (q_squared - rough * rough) * half_over;
    }
  }
};

// A lossless layer with a real angle, q^2 > 0.
template <class T, int N>
inline void cross_dispersive(const MediumRows& layer, const RayLanes<N>& ray, double thickness_nm,
                             StackWave<T, N>& wave) {
  const SquaredRows<T>& squared = layer.squared<T>();
  const Roots<T, N> roots(row_at<N>(layer.step, ray.first) + ray.q1_squared);
  const auto turn = turn_of<T, N>(roots.exact * (ray.half_turns_per_nm * thickness_nm));
  const auto over = turn.sine * roots.over_q, times = turn.sine * roots.q;
  cross(wave.s, LayerMatrix<math::packet<T, N>>{turn.cosine, over, times});
  cross(wave.p, LayerMatrix<math::packet<T, N>>{turn.cosine, over * row_at<N>(squared.n_squared, ray.first),
                                                times * row_at<N>(squared.inverse, ray.first)});
}

// The same where neither the layer nor medium 1 is dispersive: the angle and all that follows from it are single
// numbers.
template <class T, int N>
inline void cross_constant(const MediumRows& layer, const RayLanes<N>& ray, double n1_squared, double thickness_nm,
                           StackWave<T, N>& wave) {
  using P = math::packet<T, N>;
  const double q = std::sqrt(layer.step[0] + n1_squared * ray.cos2), over_q = 1 / q;
  const double n_squared = layer.in_double.n_squared[0], inverse = layer.in_double.inverse[0];
  const auto turn = turn_of<T, N>(ray.half_turns_per_nm * (q * thickness_nm));
  const auto scaled = [&](double factor) { return turn.sine * static_cast<T>(factor); };
  cross(wave.s, LayerMatrix<P>{turn.cosine, scaled(over_q), scaled(q)});
  cross(wave.p, LayerMatrix<P>{turn.cosine, scaled(n_squared * over_q), scaled(q * inverse)});
}

// q of any layer in T, by math::sqrt_upper, and with double's digits by one step of Newton's method.
template <class T, int N>
struct ComplexRoots {
  math::complex_packet<T, N> q, over_q;
  math::complex_packet<double, N> exact;

  explicit ComplexRoots(const math::complex_packet<double, N>& q_squared) {
    using P = math::packet<T, N>;
    // Below this |q|^2 the layer is at its critical angle: sin(beta)/q has reached its limit.
    constexpr T least = T(1e-30);
    const math::complex_packet<T, N> squared(math::convert<T>(q_squared.re), math::convert<T>(q_squared.im));
    q = sqrt_upper(squared);
    const P over_norm = math::reciprocal(math::max(norm(q), P(least)));
    over_q = {q.re * over_norm, -(q.im * over_norm)};
    if constexpr (sizeof(T) == 8) {
      exact = q;
    } else {
      const math::complex_packet<double, N> rough(math::convert<double>(q.re), math::convert<double>(q.im));
      const math::complex_packet<double, N> half_over(math::convert<double>(over_q.re * T(0.5)),
                                                      math::convert<double>(over_q.im * T(0.5)));
      exact = rough + (q_squared - rough * rough) * half_over;
    }
  }
};

template <class T, int N>
inline math::complex_packet<double, N> q_squared_of(const MediumRows& medium, const RayLanes<N>& ray) {
  const auto re = row_at<N>(medium.step, ray.first) + ray.q1_squared;
  if (medium.lossless) return {re};
  return {re, row_at<N>(medium.step_im, ray.first)};
}

template <class T, int N>
inline math::complex_packet<T, N> row_pair(const WavelengthRow<T>& re, const WavelengthRow<T>& im, bool lossless,
                                           std::size_t first) {
  if (lossless) return {row_at<N>(re, first)};
  return {row_at<N>(re, first), row_at<N>(im, first)};
}

// Any layer: absorbing, or beyond its critical angle.
template <class T, int N>
inline void cross_general(const MediumRows& layer, const RayLanes<N>& ray, double thickness_nm, StackWave<T, N>& wave) {
  using P = math::packet<T, N>;
  using C = math::complex_packet<T, N>;
  constexpr double pi_log2_e = std::numbers::pi * std::numbers::log2e;
  const ComplexRoots<T, N> roots(q_squared_of<T, N>(layer, ray));
  const auto per_q = ray.half_turns_per_nm * thickness_nm;
  const auto turn = turn_of<T, N>(roots.exact.re * per_q);
  const P log2_decay = math::convert<T>(roots.exact.im * (per_q * pi_log2_e));  // log2 of e^(Im beta)
  // e^(-y) cosh(y) and e^(-y) sinh(y), the latter with all its digits where it vanishes.
  const P decay_less_1 = math::exp2_minus_1(log2_decay * T(-2)), sinh = decay_less_1 * T(-0.5), cosh = T(1) - sinh;
  wave.faded += log2_decay;
  const P decay = decay_less_1 + T(1), decay_squared = decay * decay;
  wave.s.rounding *= decay_squared, wave.p.rounding *= decay_squared;
  const C cosine(turn.cosine * cosh, -(turn.sine * sinh)), sine(turn.sine * cosh, turn.cosine * sinh);
  const C over = sine * roots.over_q, times = sine * roots.q;
  const SquaredRows<T>& squared = layer.squared<T>();
  const C n_squared = row_pair<T, N>(squared.n_squared, squared.n_squared_im, layer.lossless, ray.first);
  const C inverse = row_pair<T, N>(squared.inverse, squared.inverse_im, layer.lossless, ray.first);
  cross(wave.s, LayerMatrix<C>{cosine, over, times});
  cross(wave.p, LayerMatrix<C>{cosine, over * n_squared, times * inverse});
}

// Nearer than this to its critical angle a medium is taken for one beyond it, whose formulas hold for q = 0, too: q^2 is
// a difference that may round to 0 in one lane and above 0 in the test for all.
inline constexpr double least_q_squared = 1e-12;

// Whichever the layer needs at this angle.
template <class T, int N>
inline void cross_layer(const StackTable& table, const MediumRows& layer, const RayLanes<N>& ray, double thickness_nm,
                        StackWave<T, N>& wave) {
  const bool real_angle = layer.lossless && layer.least_step + table.least_n1_squared * ray.cos2 > least_q_squared;
  if (!real_angle) return cross_general<T, N>(layer, ray, thickness_nm, wave);
  if (layer.constant)
    return cross_constant<T, N>(layer, ray, table.incidence.in_double.n_squared[0], thickness_nm, wave);
  cross_dispersive<T, N>(layer, ray, thickness_nm, wave);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
