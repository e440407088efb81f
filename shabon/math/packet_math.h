// Functions of packets that have no instruction of their own. Each states its error; tests/unit/math checks it.
#pragma once

#include <limits>
#include <numbers>

#include "shabon/math/packet.h"

namespace shabon::math {
inline namespace SHABON_REGISTERS {

// sin(pi x) for |x| <= 1/2: x times the polynomial of x^2 with the least largest relative error. The error is below
// 1.8e-7 in float and 6e-16 in double, relative too up to 2.5e-7 and 6e-16: it vanishes where the sine does.
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
  packet<double, N> p = y * -2.113362735205297e-5 + 4.659870158043378e-4;
  p = p * y - 7.3703643265304155e-3;
  p = p * y + 8.214587881631043e-2;
  p = p * y - 0.599264528825224;
  p = p * y + 2.5501640398618677;
  p = p * y - 5.1677127800497855;
  p = p * y + 3.1415926535897927;
  return p * x;
}

// cos(pi x) for |x| <= 1/2, where it is not negative. Absolute error below 1.8e-7 in float and 4e-16 in double; 1 at 0.
template <int N>
inline packet<float, N> cos_pi_reduced(packet<float, N> x) {
  const packet<float, N> y = x * x;
  packet<float, N> p = y * -2.4395932e-2f + 2.3493707e-1f;
  p = p * y - 1.3352119f;
  p = p * y + 4.0587092f;
  p = p * y - 4.9348021f;
  return p * y + 1.0f;
}

template <int N>
inline packet<double, N> cos_pi_reduced(packet<double, N> x) {
  const packet<double, N> y = x * x;
  packet<double, N> p = y * 4.149564353942586e-6 - 1.0456655338748738e-4;
  p = p * y + 1.9295562724817132e-3;
  p = p * y - 2.5806888737002202e-2;
  p = p * y + 0.23533063012953284;
  p = p * y - 1.335262768843447;
  p = p * y + 4.058712126416497;
  p = p * y - 4.934802200544676;
  return p * y + 1.0;
}

// 2^k for integers k, -126..127 in float, -1022..1023 in double: k goes into the exponent's bits.
template <class T, int N>
inline packet<T, N> power_of_two(packet<T, N> k) {
  if constexpr (!fits_register<T, N>) {
    return {power_of_two(k.lo), power_of_two(k.hi)};
  } else {
    using integers = typename packet_mask<T, N>::vector;
    constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
    constexpr T to_low_bits = sizeof(T) == 4 ? T(0x1.8p23 + 127) : T(0x1.8p52 + 1023);  // with the exponent's offset
    return packet<T, N>::wrap((integers)(k.v + to_low_bits) << mantissa_bits);
  }
}

// 2^x - 1, with a small relative error also where it vanishes: below 3e-7 in float and 1e-15 in double. x below -126
// (float) or -1022 (double) is taken as that; x must stay below 127 or 1023.
template <int N>
inline packet<float, N> exp2_minus_1(packet<float, N> x) {
  const packet<float, N> z = max(x, packet<float, N>(-126.0f)), whole = round(z), f = z - whole;
  packet<float, N> p = f * 1.5453163e-4f + 1.3390864e-3f;
  p = p * f + 9.6180826e-3f;
  p = p * f + 5.5503571e-2f;
  p = p * f + 2.4022651e-1f;
  p = (p * f + 6.9314719e-1f) * f;  // 2^f - 1
  const packet<float, N> scale = power_of_two(whole);
  return scale * p + (scale - 1.0f);
}

template <int N>
inline packet<double, N> exp2_minus_1(packet<double, N> x) {
  const packet<double, N> z = max(x, packet<double, N>(-1022.0)), whole = round(z), f = z - whole;
  packet<double, N> p = f * 4.4549605981865186e-10 + 7.072585949269223e-9;
  p = p * f + 1.0178062445845774e-7;
  p = p * f + 1.321544258792169e-6;
  p = p * f + 1.525273382983612e-5;
  p = p * f + 1.540353044173605e-4;
  p = p * f + 1.3333558146416936e-3;
  p = p * f + 9.618129107606888e-3;
  p = p * f + 5.55041086648216e-2;
  p = p * f + 0.24022650695910097;
  p = (p * f + 0.6931471805599453) * f;
  const packet<double, N> scale = power_of_two(whole);
  return scale * p + (scale - 1.0);
}

// 2^x, for the same x: relative error below 2e-7 and 5e-16. Below the range it is the least normal number.
template <class T, int N>
inline packet<T, N> exp2(packet<T, N> x) {
  const packet<T, N> z = max(x, packet<T, N>(T(sizeof(T) == 4 ? -126 : -1022))), whole = round(z);
  return power_of_two(whole) * (exp2_minus_1(z - whole) + T(1));
}

// 1/sqrt(a), relative error below 2e-7 in float and 5e-16 in double, for a from 1e-30 to 1e30.
template <class T, int N>
inline packet<T, N> reciprocal_sqrt(packet<T, N> a) {
  if constexpr (!fits_register<T, N>) {
    return {reciprocal_sqrt(a.lo), reciprocal_sqrt(a.hi)};
  } else {
#if defined(__AVX512F__)
    if constexpr (sizeof(a) == 64) {
      // 14 bits from the table; each step of Newton's method doubles them.
      const packet<T, N> half = a * T(0.5);
      packet<T, N> root;
      if constexpr (sizeof(T) == 4)
        root = packet<T, N>::wrap(_mm512_maskz_rsqrt14_ps(0xFFFF, (__m512)a.v));
      else
        root = packet<T, N>::wrap(_mm512_maskz_rsqrt14_pd(0xFF, (__m512d)a.v));
      if constexpr (sizeof(T) == 8) root = root * (T(1.5) - half * root * root);
      return root * (T(1.5) - half * root * root);
    }
#endif
    return packet<T, N>(T(1)) / sqrt(a);
  }
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
