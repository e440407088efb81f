// The film's phase for many wavelengths: formed in double, reduced, then float or double; equation (6).
#pragma once

#include "shabon/math/packet_convert.h"
#include "shabon/math/packet_math.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

template <int N, class T = float>
struct FilmPhase {
  math::packet<T, N> sin2;     // u = sin^2(beta)
  math::packet<T, N> sin_cos;  // v = sin(beta) cos(beta)
};

// phase_cycles = n d cos(theta2) / lambda, so that beta = 2 pi phase_cycles. u and v repeat every half cycle. Both come
// out with a small relative error also where they vanish, which the narrow fringes at grazing incidence need.
template <class T = float, int N>
inline FilmPhase<N, T> film_phase(math::packet<double, N> phase_cycles) {
  const math::packet<double, N> half_turns = phase_cycles + phase_cycles;
  const auto x = math::convert<T>(half_turns - math::round(half_turns));
  const auto s = math::sin_pi_reduced(x);
  // cos(pi x) = 1 - 2 sin^2(pi x / 2) has no cancellation for |x| <= 1/2, and a positive sign there.
  const auto h = math::sin_pi_reduced(x * T(0.5));
  const auto c = T(1) - T(2) * (h * h);
  return {s * s, s * c};
}

template <int N>
inline math::packet<float, N> film_phase_sin2(math::packet<double, N> phase_cycles) {
  const math::packet<double, N> half_turns = phase_cycles + phase_cycles;
  const auto s = math::sin_pi_reduced(math::convert<float>(half_turns - math::round(half_turns)));
  return s * s;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
