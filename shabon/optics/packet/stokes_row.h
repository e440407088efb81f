// The throughput of a path as seen from the eye: one row of its Mueller matrix, four packets of wavelengths.
#pragma once

#include "shabon/optics/packet/free_film.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {

template <int N, class T = float>
struct StokesRow {
  math::packet<T, N> q0, q1, q2, q3;
};

// Into the frame turned by phi from s towards p, equation (15).
template <int N, class T>
inline StokesRow<N, T> rotated(const StokesRow<N, T>& row, std::type_identity_t<T> cos_2phi,
                               std::type_identity_t<T> sin_2phi) {
  return {row.q0, row.q1 * cos_2phi + row.q2 * sin_2phi, row.q2 * cos_2phi - row.q1 * sin_2phi, row.q3};
}

// The row before a film event whose row after it is `row`, both in the plane of incidence, equation (16).
template <int N, class T>
inline StokesRow<N, T> through(const StokesRow<N, T>& row, const MuellerBlock<N, T>& m) {
  return {m.a * row.q0 + m.b * row.q1, m.b * row.q0 + m.a * row.q1, m.c * row.q2 + m.d * row.q3,
          m.c * row.q3 - m.d * row.q2};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
