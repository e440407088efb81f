// Complex numbers over packets; std::complex is specified for scalars only.
#pragma once

#include <limits>

#include "shabon/math/packet.h"

namespace shabon::math {
inline namespace SHABON_REGISTERS {

template <class T, int N>
struct complex_packet {
  packet<T, N> re, im;

  complex_packet() = default;
  complex_packet(packet<T, N> real, packet<T, N> imaginary = packet<T, N>(T(0))) : re(real), im(imaginary) {}

  friend complex_packet operator+(complex_packet a, complex_packet b) { return {a.re + b.re, a.im + b.im}; }
  friend complex_packet operator-(complex_packet a, complex_packet b) { return {a.re - b.re, a.im - b.im}; }
  friend complex_packet operator*(complex_packet a, complex_packet b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend complex_packet operator/(complex_packet a, complex_packet b) {
    const packet<T, N> scale = packet<T, N>(T(1)) / (b.re * b.re + b.im * b.im);
    return {(a.re * b.re + a.im * b.im) * scale, (a.im * b.re - a.re * b.im) * scale};
  }
};

template <class T, int N>
inline complex_packet<T, N> conj(complex_packet<T, N> a) {
  return {a.re, -a.im};
}

template <class T, int N>
inline packet<T, N> norm(complex_packet<T, N> a) {
  return a.re * a.re + a.im * a.im;
}

// The root in the upper half plane (Im >= 0, and Re >= 0 on the real axis): the wave that decays and runs forward.
template <class T, int N>
inline complex_packet<T, N> sqrt_upper(complex_packet<T, N> a) {
  using P = packet<T, N>;
  const P zero(T(0)), half(T(0.5));
  const P size = sqrt(norm(a));
  const P larger = sqrt(max(half * (size + abs(a.re)), zero));
  const P smaller = half * abs(a.im) / max(larger, P(std::numeric_limits<T>::min()));
  const auto forward = a.re >= zero;
  P re = select(forward, larger, smaller), im = select(forward, smaller, larger);
  re = select(a.im < zero, -re, re);
  return {re, im};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::math
