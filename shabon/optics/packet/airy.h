// One layer between any two media for many wavelengths, absorbing or not: equations (1) to (9) in double lanes. The
// lossless film between equal media has a faster form in free_film.h.
#pragma once

#include <cmath>

#include "shabon/math/packet_complex.h"
#include "shabon/optics/packet/phase.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

template <int N>
struct LayerLanes {
  math::complex_packet<double, N> n1, n2, n3;
  math::packet<double, N> inverse_wavelength_per_nm;
};

template <int N>
struct AmplitudeLanes {
  math::complex_packet<double, N> r_s, r_p, t_s, t_p;
  math::packet<double, N> transmission_s, transmission_p;  // the factors of equation (9): T = factor |t|^2
};

// What crossing the layer once does: the round trip e^(2 i beta) and the single pass e^(i beta).
template <int N>
struct LayerPass {
  math::complex_packet<double, N> single, round_trip;
};

template <int N>
inline LayerPass<N> layer_pass(math::complex_packet<double, N> q2, math::packet<double, N> thickness_per_wavelength) {
  using D = math::packet<double, N>;
  const D half_turns = 2.0 * (q2.re * thickness_per_wavelength);
  const D whole = math::round(half_turns);
  const auto x = math::convert<float>(half_turns - whole);
  const D s = math::convert<double>(math::sin_pi_reduced(x));
  const D h = math::convert<double>(math::sin_pi_reduced(x * 0.5f));
  const D c = 1.0 - 2.0 * (h * h);
  const D odd = whole - 2.0 * math::round(whole * 0.5);  // -1, 0 or 1: an odd number of half turns changes the sign
  const D sign = 1.0 - 2.0 * (odd * odd);
  D decay(1.0);
  if (math::any(q2.im > D(0.0))) {
    double exponent[N];
    (q2.im * thickness_per_wavelength * (-2 * std::numbers::pi)).store(exponent);
    for (double& e : exponent) e = std::exp(e);
    decay = D::load(exponent);
  }
  return {{decay * sign * c, decay * sign * s}, {decay * decay * (1.0 - 2.0 * (s * s)), decay * decay * (2.0 * (s * c))}};
}

// thickness_nm >= 0; sin_i and cos_i belong to the angle in medium 1, cos_i > 0 (keep it above 1e-8).
template <int N>
inline AmplitudeLanes<N> airy_amplitudes(const LayerLanes<N>& at, double thickness_nm, double cos_i, double sin_i) {
  using D = math::packet<double, N>;
  using C = math::complex_packet<double, N>;
  const C one(D(1.0)), two(D(2.0));
  const C n1_2 = at.n1 * at.n1, n2_2 = at.n2 * at.n2, n3_2 = at.n3 * at.n3;
  const C kappa = n1_2 * C(D(sin_i * sin_i));
  const C q1 = at.n1 * C(D(cos_i)), q2 = sqrt_upper(n2_2 - kappa), q3 = sqrt_upper(n3_2 - kappa);  // n cos(theta), (1)
  const LayerPass<N> pass = layer_pass(q2, at.inverse_wavelength_per_nm * thickness_nm);
  const auto summed = [&](const C& r12, const C& r23, const C& t12, const C& t23, C& r, C& t) {
    const C below = one + r12 * r23 * pass.round_trip;
    r = (r12 + r23 * pass.round_trip) / below;  // (7)
    t = t12 * t23 * pass.single / below;        // (8)
  };
  AmplitudeLanes<N> result;
  summed((q1 - q2) / (q1 + q2), (q2 - q3) / (q2 + q3), two * q1 / (q1 + q2), two * q2 / (q2 + q3), result.r_s,
         result.t_s);
  const C a1 = n2_2 * q1, a2 = n1_2 * q2, b2 = n3_2 * q2, b3 = n2_2 * q3;
  summed((a1 - a2) / (a1 + a2), (b2 - b3) / (b2 + b3), two * at.n1 * at.n2 * q1 / (a1 + a2),
         two * at.n2 * at.n3 * q2 / (b2 + b3), result.r_p, result.t_p);
  result.transmission_s = q3.re / q1.re;
  result.transmission_p = (at.n3 * conj(q3 / at.n3)).re / (at.n1 * conj(q1 / at.n1)).re;
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
