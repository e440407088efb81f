// One layer between any two media for many wavelengths, absorbing or not: equations (1) to (9) in double lanes. The
// lossless film between equal media has a faster form in free_film.h.
//
// With u = q for s, u = q/n^2 for p, q = n cos(theta), equations (7) and (8) are
//   r = ((u1 - u3) cos(beta) - i (u1 u3/u2 - u2) sin(beta)) / D,  t = 2 u1 / D,
//   D =  (u1 + u3) cos(beta) - i (u1 u3/u2 + u2) sin(beta);
// t_p is n1/n3 times that, a ratio of electric fields. Nothing cancels at grazing incidence, and the critical angle,
// where q2 vanishes, is no special spot: sin(beta)/q2 has a limit there. Errors stay below 1e-9.
#pragma once

#include <cmath>
#include <numbers>

#include "shabon/math/packet_complex.h"
#include "shabon/optics/packet/phase.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

template <int N>
struct LayerLanes {
  math::complex_packet<double, N> n1, n2, n3;  // medium 1 without loss
  math::packet<double, N> inverse_wavelength_per_nm;
};

template <int N>
struct AmplitudeLanes {
  math::complex_packet<double, N> r_s, r_p, t_s, t_p;
  math::packet<double, N> transmission_s, transmission_p;  // the factors of equation (9): T = factor |t|^2
};

// The layer's trigonometry, times e^(-Im beta) so that an opaque layer does not overflow.
template <int N>
struct LayerTerms {
  math::complex_packet<double, N> cos_beta, sin_beta, sin_beta_over_q2;
  math::packet<double, N> decay;  // e^(-Im beta)
};

// e^(-y) and e^(-y) sinh(y) for y >= 0; the latter keeps its digits where it vanishes.
template <int N>
inline void decay_and_sinh(math::packet<double, N> y, math::packet<double, N>& decay, math::packet<double, N>& sinh) {
  using D = math::packet<double, N>;
  double lane[N];
  y.store(lane);
  for (double& e : lane) e = std::exp(-e);
  decay = D::load(lane);
  const D series = y * (1.0 - y * (1.0 - y * (2.0 / 3 - y * (1.0 / 3))));  // to y^4; the rest is below y^5
  sinh = select(y < D(1e-4), series, 0.5 * (1.0 - decay * decay));
}

template <int N>
inline LayerTerms<N> layer_terms(math::complex_packet<double, N> q2, math::packet<double, N> thickness_per_wavelength) {
  using D = math::packet<double, N>;
  using C = math::complex_packet<double, N>;
  constexpr double two_pi = 2 * std::numbers::pi;
  const D half_turns = 2.0 * (q2.re * thickness_per_wavelength);
  const D whole = math::round(half_turns), x = half_turns - whole;
  const D h = math::sin_pi_reduced(x * 0.5);
  const D odd = whole - 2.0 * math::round(whole * 0.5);  // -1, 0 or 1: an odd number of half turns changes the sign
  const D sign = 1.0 - 2.0 * (odd * odd);
  const D sine = sign * math::sin_pi_reduced(x), cosine = sign * (1.0 - 2.0 * (h * h));
  D decay(1.0), sinh(0.0);
  if (math::any(q2.im > D(0.0))) decay_and_sinh(q2.im * thickness_per_wavelength * two_pi, decay, sinh);
  const D cosh = decay * decay + sinh;  // times e^(-y), as sinh is
  const C sin_beta(sine * cosh, cosine * sinh);
  const D size = norm(q2);
  const auto vanishes = size == D(0.0);
  C over_q2 = sin_beta * conj(q2) * C(1.0 / select(vanishes, D(1.0), size));
  over_q2.re = select(vanishes, thickness_per_wavelength * two_pi, over_q2.re);
  return {C(cosine * cosh, -(sine * sinh)), sin_beta, over_q2, decay};
}

// One polarisation: (7) and (8), t without the factor n1/n3 of p.
template <int N>
struct LayerSum {
  math::complex_packet<double, N> r, t;
};

template <int N>
inline LayerSum<N> layer_sum(const math::complex_packet<double, N>& u1, const math::complex_packet<double, N>& u3,
                             const math::complex_packet<double, N>& sin_over_u2,
                             const math::complex_packet<double, N>& u2_sin, const LayerTerms<N>& layer) {
  using C = math::complex_packet<double, N>;
  const auto times_i = [](const C& z) { return C(-z.im, z.re); };
  const C through = u1 * u3 * sin_over_u2;
  const C over = C(math::packet<double, N>(1.0)) / ((u1 + u3) * layer.cos_beta - times_i(through + u2_sin));
  return {((u1 - u3) * layer.cos_beta - times_i(through - u2_sin)) * over, (u1 + u1) * C(layer.decay) * over};
}

// thickness_nm >= 0; cos_i belongs to the angle in medium 1 and is positive (keep it above 1e-8).
template <int N>
inline AmplitudeLanes<N> airy_amplitudes(const LayerLanes<N>& at, double thickness_nm, double cos_i) {
  using D = math::packet<double, N>;
  using C = math::complex_packet<double, N>;
  const C one(D(1.0)), q1 = at.n1 * C(D(cos_i)), q1_squared = q1 * q1;
  // (1): n^2 - n1^2 sin^2 = (n - n1)(n + n1) + q1^2, in which nothing cancels where q1 or n - n1 is small.
  const C q2 = sqrt_upper((at.n2 - at.n1) * (at.n2 + at.n1) + q1_squared);
  const C q3 = sqrt_upper((at.n3 - at.n1) * (at.n3 + at.n1) + q1_squared);
  const LayerTerms<N> layer = layer_terms(q2, at.inverse_wavelength_per_nm * thickness_nm);
  const C over_n1 = one / at.n1, over_n3 = one / at.n3, n2_squared = at.n2 * at.n2;
  const C c1_over_n1 = q1 * over_n1 * over_n1, c3_over_n3 = q3 * over_n3 * over_n3;
  const auto s = layer_sum(q1, q3, layer.sin_beta_over_q2, q2 * layer.sin_beta, layer);
  const auto p =
      layer_sum(c1_over_n1, c3_over_n3, n2_squared * layer.sin_beta_over_q2, q2 * layer.sin_beta / n2_squared, layer);
  AmplitudeLanes<N> result;
  result.r_s = s.r, result.t_s = s.t;
  result.r_p = p.r, result.t_p = p.t * at.n1 * over_n3;
  result.transmission_s = q3.re / q1.re;
  result.transmission_p = (at.n3 * conj(q3 * over_n3)).re / q1.re;
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
