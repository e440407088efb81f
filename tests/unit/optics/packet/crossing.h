// The kernels' inputs as the renderer forms them: squares and roots in double, for one index or one per lane.
#pragma once

#include <algorithm>
#include <cmath>

#include "film_cases.h"
#include "shabon/optics/packet/free_film.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

template <class L, class D>
struct Crossing {
  D n1_squared, n2_squared, q1_squared, q2_squared, q1, q2;
  FreeFilmIndices<L> indices;
  Double phase_cycles;

  FreeFilmAngle<L> angle() const {
    return {math::narrow(q1_squared), math::narrow(q2_squared), math::narrow(n1_squared - q1_squared)};
  }
  FreeFilmFactors<L> factors() const { return free_film_factors(indices, angle()); }
  FreeFilmTurn<L> turn() const { return free_film_turn(indices, angle()); }
};

template <class L, class D>
Crossing<L, D> crossing(D n1_squared, D n2_squared, const FilmCase& film) {
  using std::sqrt;
  const D q1_squared = n1_squared * D(std::max(film.cos_i * film.cos_i, least_cos2));
  const D q2_squared = n2_squared - n1_squared + q1_squared, q2 = sqrt(q2_squared);
  return {n1_squared,
          n2_squared,
          q1_squared,
          q2_squared,
          sqrt(q1_squared),
          q2,
          free_film_indices(n1_squared, n2_squared),
          Double(1.0) / Double::load(film.wavelength_nm) * film.thickness_nm * Double(q2)};
}

// One index for all lanes, that of the first.
inline Crossing<float, double> constant_crossing(const FilmCase& film) {
  return crossing<float, double>(film.n1[0] * film.n1[0], film.n2[0] * film.n2[0], film);
}

inline Crossing<Float, Double> dispersive_crossing(const FilmCase& film) {
  const Double n1 = Double::load(film.n1), n2 = Double::load(film.n2);
  return crossing<Float, Double>(n1 * n1, n2 * n2, film);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
