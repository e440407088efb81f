// Functions of packets that have no instruction of their own. Each states its error; tests/unit/math checks it.
#pragma once

#include <numbers>

#include "shabon/math/packet.h"

namespace shabon::math {
inline namespace SHABON_REGISTERS {

// sin(pi x) for |x| <= 1/2: x times the polynomial of x^2 with the least largest relative error. The error is below
// 1.8e-7 in float and 1e-13 in double, relative too up to 2.5e-7 and 1e-13: it vanishes where the sine does.
template <int N>
inline packet<float, N> sin_pi_reduced(packet<float, N> x) {
  const packet<float, N> y = x * x;
  packet<float, N> p = y * -7.3704309e-3f + 8.2145887e-2f;
  p = p * y - 5.9926453e-1f;
  p = p * y + 2.5501640f;
  p = p * y - 5.1677128f;
  p = p * y + 3.1415927f;
  return p * x;
}

template <int N>
inline packet<double, N> sin_pi_reduced(packet<double, N> x) {
  const packet<double, N> y = x * x;
  packet<double, N> p = y * 4.472002837583736e-4 - 7.363785018662142e-3;
  p = p * y + 8.214473211270053e-2;
  p = p * y - 0.5992644257354168;
  p = p * y + 2.5501640354193094;
  p = p * y - 5.167712779977312;
  p = p * y + 3.1415926535895973;
  return p * x;
}

// The angle of (x, y) in radians, -pi..pi; absolute error below 4e-7 (one of x and y above 1e-37). atan2(0, 0) is 0.
template <int N>
inline packet<float, N> atan2(packet<float, N> y, packet<float, N> x) {
  using P = packet<float, N>;
  const P ax = abs(x), ay = abs(y);
  const P larger = max(ax, ay), smaller = min(ax, ay);
  const P t = smaller / max(larger, P(1e-37f));
  const P s = t * t;
  // atan(t)/t on 0..1, least maximum error, degree 8 in t^2.
  P p = s * 0.0028662257f - 0.0161657367f;
  p = p * s + 0.0429096138f;
  p = p * s - 0.0752896400f;
  p = p * s + 0.1065626393f;
  p = p * s - 0.1420889944f;
  p = p * s + 0.1999355085f;
  p = p * s - 0.3333314528f;
  P angle = p * s * t + t;
  angle = select(ay > ax, P(std::numbers::pi / 2) - angle, angle);
  angle = select(x < P(0.0f), P(std::numbers::pi) - angle, angle);
  return select(y < P(0.0f), -angle, angle);
}

// The angle, 0..pi, whose cosine is x; |x| <= 1, beyond that it is clamped. Absolute error below 4e-7.
template <int N>
inline packet<float, N> acos(packet<float, N> x) {
  using P = packet<float, N>;
  return atan2(sqrt(max(P(0.0f), (P(1.0f) - x) * (P(1.0f) + x))), x);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::math
