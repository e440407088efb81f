// The paper's two-beam film and the film without phase, lossless and between equal media, for many wavelengths:
// equations (11), (12) and (14). Unclamped, as the reference returns them.
#pragma once

#include "shabon/optics/packet/free_film.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

// rho and 1 - rho of one wall and polarisation, neither by subtraction from 1.
template <class L>
struct WallReflectance {
  L rho_s, pass_s, rho_p, pass_p;
};

template <class L, class D>
inline WallReflectance<L> wall_reflectance(D n1_squared, D n2_squared, D q1, D q2) {
  const D plus_s = q1 + q2, minus_s = q1 - q2;
  const D plus_p = n2_squared * q1 + n1_squared * q2, minus_p = n2_squared * q1 - n1_squared * q2;
  const D over_s = D(1.0) / (plus_s * plus_s), over_p = D(1.0) / (plus_p * plus_p);
  return {math::narrow(minus_s * minus_s * over_s), math::narrow(D(4.0) * q1 * q2 * over_s),
          math::narrow(minus_p * minus_p * over_p), math::narrow(D(4.0) * n1_squared * n2_squared * q1 * q2 * over_p)};
}

template <int N, class L>
inline FilmPowers<N> two_beam_powers(const WallReflectance<L>& wall, math::packet<float, N> sin2) {
  using P = math::packet<float, N>;
  const auto reflected = [&](const P& rho, const P& pass) { return rho * (rho * rho + 4.0f * (pass * sin2)); };
  const P pass_s(wall.pass_s), pass_p(wall.pass_p);
  return {reflected(P(wall.rho_s), pass_s), reflected(P(wall.rho_p), pass_p), pass_s * pass_s, pass_p * pass_p};
}

template <int N, class L>
inline FilmPowers<N> without_phase_powers(const WallReflectance<L>& wall) {
  using P = math::packet<float, N>;
  const P rho_s(wall.rho_s), rho_p(wall.rho_p);
  const P over_s = 1.0f / (1.0f + rho_s), over_p = 1.0f / (1.0f + rho_p);
  return {2.0f * (rho_s * over_s), 2.0f * (rho_p * over_p), P(wall.pass_s) * over_s, P(wall.pass_p) * over_p};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
