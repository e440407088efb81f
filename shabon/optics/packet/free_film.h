// The lossless film between equal media, for many wavelengths at once, in the real form of equation (10):
//   r_s = -i H_s sin(beta)/(cos(beta) - i G_s sin(beta)),  t_s = 1/(cos(beta) - i G_s sin(beta)), likewise p, with
//   H_s = (q1^2 - q2^2)/(2 q1 q2), G_s = (q1^2 + q2^2)/(2 q1 q2), q = n cos(theta).
// Multiplied through by Y = 4 q1^2 q2^2 everything is a polynomial over one shared denominator: no sum of near-equal
// terms, no special spot at grazing incidence.
#pragma once

#include <algorithm>
#include <cmath>

#include "shabon/optics/packet/phase.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

// cos_i^2 is kept above this, so that the factors of a ray exactly along the film stay finite; R is 1 there to 1e-7.
inline constexpr double least_cos2 = 1e-16;

// And Y above this, so that its square is a float where the film has nearly the index of the medium as well.
inline constexpr float least_crossing = 1e-18f;

// What the two indices alone decide. L is a number (constant over the wavelengths) or a packet, of float or of double.
template <class L>
struct FreeFilmIndices {
  L contrast;  // X = (n2^2 - n1^2)^2
  L slope;     // 1/n1^2 + 1/n2^2
  L ratio;     // n2^2/n1^2
  L inverse_ratio;
  L inverse_product;  // 1/(n1^2 n2^2)
};

template <class D>
inline FreeFilmIndices<D> exact_free_film_indices(D n1_squared, D n2_squared) {
  const D one(1.0), product = n1_squared * n2_squared, step = n2_squared - n1_squared;
  return {step * step, (n1_squared + n2_squared) / product, n2_squared / n1_squared, n1_squared / n2_squared,
          one / product};
}

// Formed in double and rounded to float.
template <class D>
inline auto free_film_indices(D n1_squared, D n2_squared) {
  using math::narrow;
  const FreeFilmIndices<D> exact = exact_free_film_indices(n1_squared, n2_squared);
  using L = decltype(narrow(n1_squared));
  return FreeFilmIndices<L>{narrow(exact.contrast), narrow(exact.slope), narrow(exact.ratio),
                            narrow(exact.inverse_ratio), narrow(exact.inverse_product)};
}

// What the angle decides: q1^2, q2^2 and kappa = n1^2 sin^2(theta1), each formed in double.
template <class L>
struct FreeFilmAngle {
  L q1_squared, q2_squared, kappa;
};

// Together, as far as the powers need them.
template <class L>
struct FreeFilmFactors {
  L contrast;  // X
  L crossing;  // Y = 4 q1^2 q2^2
  L brewster;  // g = 1 - kappa (1/n1^2 + 1/n2^2) = q1^2 (1/n1^2 + 1/n2^2) - n1^2/n2^2, zero at Brewster's angle
};

template <class L>
inline FreeFilmFactors<L> free_film_factors(const FreeFilmIndices<L>& n, const FreeFilmAngle<L>& at) {
  using std::max;
  return {n.contrast, max(L(4.0f) * at.q1_squared * at.q2_squared, L(least_crossing)),
          at.q1_squared * n.slope - n.inverse_ratio};
}

// And what the phase between s and p needs besides.
template <class L>
struct FreeFilmTurn {
  L mean;   // P_s P_p = (q1^2 + q2^2)(q1^2 n2^2/n1^2 + q2^2 n1^2/n2^2)
  L twist;  // 2 q1 q2 X kappa/(n1^2 n2^2), which turns linear light elliptical
};

template <class L>
inline FreeFilmTurn<L> free_film_turn(const FreeFilmIndices<L>& n, const FreeFilmAngle<L>& at) {
  using std::sqrt;
  return {(at.q1_squared + at.q2_squared) * (at.q1_squared * n.ratio + at.q2_squared * n.inverse_ratio),
          L(2.0f) * sqrt(at.q1_squared) * sqrt(at.q2_squared) * n.contrast * at.kappa * n.inverse_product};
}

// Reflectance and transmittance of both polarisations.
template <int N>
struct FilmPowers {
  math::packet<float, N> R_s, R_p, T_s, T_p;
};

template <int N, class L>
inline FilmPowers<N> free_film_powers(const FreeFilmFactors<L>& f, math::packet<float, N> sin2) {
  using P = math::packet<float, N>;
  const P Y(f.crossing);
  const P a = P(f.contrast) * sin2;
  const P b = a * P(f.brewster * f.brewster);
  const P both_s = Y + a, both_p = Y + b;
  const P one_over = math::reciprocal(both_s * both_p);
  const P over_s = both_p * one_over, over_p = both_s * one_over;
  return {a * over_s, b * over_p, Y * over_s, Y * over_p};
}

// The two blocks of the Mueller row, equation (16): a = (|x_s|^2 + |x_p|^2)/2, b = (|x_s|^2 - |x_p|^2)/2,
// c + i d = x_s conj(x_p) for x = r and x = t.
template <int N, class T = float>
struct MuellerBlock {
  math::packet<T, N> a, b, c, d;
};

template <int N, class T = float>
struct FilmMueller {
  MuellerBlock<N, T> reflected, transmitted;
};

template <int N, class T, class L>
inline FilmMueller<N, T> free_film_mueller(const FreeFilmFactors<L>& f, const FreeFilmTurn<L>& turn,
                                           const FilmPhase<N, T>& phase) {
  using P = math::packet<T, N>;
  const P Y(f.crossing), g(f.brewster);
  const P x = P(f.contrast) * phase.sin2;
  const P y = x * g * g;
  const P both_s = Y + x, both_p = Y + y;
  const P one_over = math::reciprocal(both_s * both_p);
  const P over_s = both_p * one_over, over_p = both_s * one_over;
  const P half(T(0.5));
  const P R_s = x * over_s * half, R_p = y * over_p * half, T_s = Y * over_s * half, T_p = Y * over_p * half;
  const P in_phase = (Y * (T(1) - phase.sin2) + P(turn.mean) * phase.sin2) * one_over;
  const P quarter = P(turn.twist) * phase.sin_cos * one_over;
  const P turned = -(x * g);  // H_s H_p u Y: s and p reflect in opposite sense below Brewster's angle
  return {{R_s + R_p, R_s - R_p, turned * in_phase, turned * quarter},
          {T_s + T_p, T_s - T_p, Y * in_phase, Y * quarter}};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
