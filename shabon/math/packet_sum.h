// One number from the lanes of a packet: their sum, the largest of them.
#pragma once

#include "shabon/math/packet.h"

namespace shabon::math {
inline namespace SHABON_REGISTERS {

// The sum of all lanes, always added in the same order: halves first.
template <class T, int N>
inline T sum(packet<T, N> a) {
  if constexpr (N == 1) {
    return a[0];
  } else if constexpr (!fits_register<T, N>) {
    return sum(a.lo + a.hi);
#if defined(__AVX512F__)
  } else if constexpr (sizeof(a) == 64 && sizeof(T) == 4) {
    const auto low = __builtin_shufflevector(a.v, a.v, 0, 1, 2, 3, 4, 5, 6, 7);
    const auto high = __builtin_shufflevector(a.v, a.v, 8, 9, 10, 11, 12, 13, 14, 15);
    return sum(packet<T, N / 2>::wrap(low + high));
#endif
#if defined(__AVX2__)
  } else if constexpr (sizeof(a) == 32 && sizeof(T) == 4) {
    return sum(packet<T, N / 2>::wrap(_mm256_castps256_ps128((__m256)a.v) + _mm256_extractf128_ps((__m256)a.v, 1)));
  } else if constexpr (sizeof(a) == 16 && sizeof(T) == 4) {
    const __m128 pairs = (__m128)a.v + _mm_movehl_ps((__m128)a.v, (__m128)a.v);
    return pairs[0] + pairs[1];
#endif
  } else {
    packet<T, N / 2> low, high;
    std::memcpy(&low, &a, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&a) + sizeof low, sizeof high);
    return sum(low + high);
  }
}

template <class T, int N>
inline T largest(packet<T, N> a) {
  if constexpr (N == 1) {
    return a[0];
  } else if constexpr (!fits_register<T, N>) {
    return largest(max(a.lo, a.hi));
  } else {
    packet<T, N / 2> low, high;
    std::memcpy(&low, &a, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&a) + sizeof low, sizeof high);
    return largest(max(low, high));
  }
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::math
