// Packets of one number type to another.
#pragma once

#include <utility>

#include "shabon/math/packet.h"

namespace shabon::math {
inline namespace SHABON_REGISTERS {

template <class T, int N, int... lane>
inline packet<T, 2 * N> joined(packet<T, N> low, packet<T, N> high, std::integer_sequence<int, lane...>) {
  return packet<T, 2 * N>::wrap(__builtin_shufflevector(low.v, high.v, lane...));
}

template <int first, class T, int N, int... lane>
inline packet<T, N / 2> part(packet<T, N> a, std::integer_sequence<int, lane...>) {
  return packet<T, N / 2>::wrap(__builtin_shufflevector(a.v, a.v, (first + lane)...));
}

// Lane by lane to another number type.
template <class To, class T, int N>
inline packet<To, N> convert(packet<T, N> a) {
  if constexpr (std::is_same_v<To, T>) {
    return a;
  } else if constexpr (fits_register<T, N> && fits_register<To, N>) {
    return packet<To, N>::wrap(__builtin_convertvector(a.v, typename packet<To, N>::vector));
  } else {
    packet<T, N / 2> halves[2];
    if constexpr (fits_register<T, N>) {
      halves[0] = part<0>(a, std::make_integer_sequence<int, N / 2>());
      halves[1] = part<N / 2>(a, std::make_integer_sequence<int, N / 2>());
    } else {
      halves[0] = a.lo, halves[1] = a.hi;
    }
    const packet<To, N / 2> low = convert<To>(halves[0]), high = convert<To>(halves[1]);
    if constexpr (fits_register<To, N>) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
      if constexpr (sizeof(To) == 4 && N == 16)
        return packet<To, N>::wrap(_mm512_insertf32x8(_mm512_castps256_ps512((__m256)low.v), (__m256)high.v, 1));
#endif
      return joined(low, high, std::make_integer_sequence<int, N>());
    } else {
      return {low, high};
    }
  }
}

// Double to float, for one number or a packet of them.
inline float narrow(double value) { return static_cast<float>(value); }
template <int N>
inline packet<float, N> narrow(packet<double, N> value) {
  return convert<float>(value);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::math
