// packet<T, N>: N numbers computed at once. A leaf is one register of the machine the file is compiled for; wider
// packets are two halves. Everything lies in an inline namespace named after the register width, so that code compiled
// for different machines never shares a symbol; for the same reason this header is not installed.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__AVX512F__)
#define SHABON_REGISTERS registers_64
#elif defined(__AVX2__)
#define SHABON_REGISTERS registers_32
#else
#define SHABON_REGISTERS registers_16
#endif

namespace shabon::math {
inline namespace SHABON_REGISTERS {

#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

template <class T, int N>
inline constexpr bool fits_register = N* static_cast<int>(sizeof(T)) <= register_bytes;

template <class T>
using mask_lane = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

// The result of a comparison: one truth value per lane.
template <class T, int N>
struct packet_mask {
  packet_mask<T, N / 2> lo, hi;
};

template <class T, int N>
requires fits_register<T, N>
struct packet_mask<T, N> {
  typedef mask_lane<T> vector __attribute__((vector_size(N * sizeof(T))));
  vector v;
};

template <class T, int N>
struct packet {
  static constexpr int size = N;
  packet<T, N / 2> lo, hi;

  packet() = default;
  packet(T value) : lo(value), hi(value) {}
  packet(packet<T, N / 2> low, packet<T, N / 2> high) : lo(low), hi(high) {}

  static packet load(const T* from) { return {packet<T, N / 2>::load(from), packet<T, N / 2>::load(from + N / 2)}; }
  void store(T* to) const { lo.store(to), hi.store(to + N / 2); }
  T operator[](int lane) const { return lane < N / 2 ? lo[lane] : hi[lane - N / 2]; }
};

template <class T, int N>
requires fits_register<T, N>
struct packet<T, N> {
  static constexpr int size = N;
  typedef T vector __attribute__((vector_size(N * sizeof(T))));
  vector v;

  packet() = default;
  packet(T value) : v(vector{} + value) {}

  template <class V>
  static packet wrap(V value) {  // from the compiler's own vector type, or an intrinsic's
    packet result;
    result.v = (vector)value;
    return result;
  }
  static packet load(const T* from) {
    packet result;
    std::memcpy(&result.v, from, sizeof(vector));
    return result;
  }
  void store(T* to) const { std::memcpy(to, &v, sizeof(vector)); }
  T operator[](int lane) const { return v[lane]; }
};

template <class P>
inline constexpr bool is_leaf = fits_register<std::remove_cvref_t<decltype(P{}[0])>, P::size>;

// Arithmetic, lane by lane. The scalar overloads keep `2 * x` readable.
#define SHABON_PACKET_BINARY(op)                                               \
  template <class T, int N>                                                    \
  inline packet<T, N> operator op(packet<T, N> a, packet<T, N> b) {            \
    if constexpr (fits_register<T, N>)                                         \
      return packet<T, N>::wrap(a.v op b.v);                                   \
    else                                                                       \
      return {a.lo op b.lo, a.hi op b.hi};                                     \
  }                                                                            \
  template <class T, int N>                                                    \
  inline packet<T, N> operator op(packet<T, N> a, std::type_identity_t<T> b) { \
    return a op packet<T, N>(b);                                               \
  }                                                                            \
  template <class T, int N>                                                    \
  inline packet<T, N> operator op(std::type_identity_t<T> a, packet<T, N> b) { \
    return packet<T, N>(a) op b;                                               \
  }
SHABON_PACKET_BINARY(+)
SHABON_PACKET_BINARY(-)
SHABON_PACKET_BINARY(*)
SHABON_PACKET_BINARY(/)
#undef SHABON_PACKET_BINARY

#define SHABON_PACKET_COMPARE(op)                                        \
  template <class T, int N>                                              \
  inline packet_mask<T, N> operator op(packet<T, N> a, packet<T, N> b) { \
    if constexpr (fits_register<T, N>)                                   \
      return {a.v op b.v};                                               \
    else                                                                 \
      return {a.lo op b.lo, a.hi op b.hi};                               \
  }
SHABON_PACKET_COMPARE(<)
SHABON_PACKET_COMPARE(<=)
SHABON_PACKET_COMPARE(>)
SHABON_PACKET_COMPARE(>=)
SHABON_PACKET_COMPARE(==)
#undef SHABON_PACKET_COMPARE

#define SHABON_MASK_BINARY(op)                                                     \
  template <class T, int N>                                                        \
  inline packet_mask<T, N> operator op(packet_mask<T, N> a, packet_mask<T, N> b) { \
    if constexpr (fits_register<T, N>)                                             \
      return {a.v op b.v};                                                         \
    else                                                                           \
      return {a.lo op b.lo, a.hi op b.hi};                                         \
  }
SHABON_MASK_BINARY(&)
SHABON_MASK_BINARY(|)
#undef SHABON_MASK_BINARY

template <class T, int N>
inline packet<T, N> operator-(packet<T, N> a) {
  if constexpr (fits_register<T, N>)
    return packet<T, N>::wrap(-a.v);
  else
    return {-a.lo, -a.hi};
}

template <class T, int N>
inline packet<T, N>& operator+=(packet<T, N>& a, packet<T, N> b) {
  return a = a + b;
}

template <class T, int N>
inline packet<T, N>& operator*=(packet<T, N>& a, packet<T, N> b) {
  return a = a * b;
}

template <class T, int N>
inline packet<T, N> select(packet_mask<T, N> mask, packet<T, N> yes, packet<T, N> no) {
  if constexpr (fits_register<T, N>)
    return packet<T, N>::wrap(mask.v ? yes.v : no.v);
  else
    return {select(mask.lo, yes.lo, no.lo), select(mask.hi, yes.hi, no.hi)};
}

template <class T, int N>
inline packet<T, N> min(packet<T, N> a, packet<T, N> b) {
  return select(a < b, a, b);
}

template <class T, int N>
inline packet<T, N> max(packet<T, N> a, packet<T, N> b) {
  return select(a > b, a, b);
}

template <class T, int N>
inline packet<T, N> abs(packet<T, N> a) {
  if constexpr (fits_register<T, N>) {
    using integers = typename packet_mask<T, N>::vector;
    return packet<T, N>::wrap((integers)a.v & std::numeric_limits<mask_lane<T>>::max());  // all but the sign bit
  } else {
    return {abs(a.lo), abs(a.hi)};
  }
}

// from[index[0]], from[index[1]] and so on, without a detour through memory.
template <class P, class T, class Index>
inline P gathered(const T* from, const Index* index) {
  if constexpr (is_leaf<P>) {
    P result;
    for (int lane = 0; lane < P::size; ++lane) result.v[lane] = from[static_cast<std::size_t>(index[lane])];
    return result;
  } else {
    using Half = decltype(P::lo);
    return {gathered<Half>(from, index), gathered<Half>(from, index + Half::size)};
  }
}

// The lane's truth value as bit `lane`.
template <class T, int N>
inline std::uint32_t bits(packet_mask<T, N> mask) {
  if constexpr (fits_register<T, N>) {
#if defined(__AVX512F__) && defined(__AVX512DQ__)
    if constexpr (sizeof(mask.v) == 64 && sizeof(T) == 4) return _mm512_movepi32_mask((__m512i)mask.v);
    if constexpr (sizeof(mask.v) == 64 && sizeof(T) == 8) return _mm512_movepi64_mask((__m512i)mask.v);
#endif
    std::uint32_t result = 0;
    for (int lane = 0; lane < N; ++lane) result |= mask.v[lane] ? 1u << lane : 0u;
    return result;
  } else {
    return bits(mask.lo) | bits(mask.hi) << (N / 2);
  }
}

template <class T, int N>
inline bool any(packet_mask<T, N> mask) {
  return bits(mask) != 0;
}

// 1/a with a relative error below 2e-7 in float and 5e-16 in double, for normal numbers whose reciprocal is normal too.
template <class T, int N>
inline packet<T, N> reciprocal(packet<T, N> a) {
#if defined(__AVX512F__)
  if constexpr (sizeof(a) == 64) {
    // 14 bits from the table; each step of Newton's method doubles them.
    if constexpr (sizeof(T) == 4) {
      const auto rough = packet<T, N>::wrap(_mm512_maskz_rcp14_ps(0xFFFF, (__m512)a.v));
      return rough * (2.0f - a * rough);
    } else if constexpr (N == 8) {
      auto rough = packet<T, N>::wrap(_mm512_maskz_rcp14_pd(0xFF, (__m512d)a.v));
      rough = rough * (2.0 - a * rough);
      return rough + rough * (1.0 - a * rough);
    }
  }
#endif
  return packet<T, N>(T(1)) / a;
}

// Some compilers turn a loop over std::sqrt into one instruction, some do not.
template <class T, int N>
inline packet<T, N> sqrt(packet<T, N> a) {
  if constexpr (!fits_register<T, N>) {
    return {sqrt(a.lo), sqrt(a.hi)};
  } else {
#if defined(__AVX512F__)
    if constexpr (sizeof(a) == 64 && sizeof(T) == 4)
      return packet<T, N>::wrap(_mm512_maskz_sqrt_ps(0xFFFF, (__m512)a.v));
    if constexpr (sizeof(a) == 64 && sizeof(T) == 8)
      return packet<T, N>::wrap(_mm512_maskz_sqrt_pd(0xFF, (__m512d)a.v));
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(a) == 32 && sizeof(T) == 4) return packet<T, N>::wrap(_mm256_sqrt_ps((__m256)a.v));
    if constexpr (sizeof(a) == 32 && sizeof(T) == 8) return packet<T, N>::wrap(_mm256_sqrt_pd((__m256d)a.v));
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(a) == 16 && sizeof(T) == 4) return packet<T, N>::wrap(_mm_sqrt_ps((__m128)a.v));
    if constexpr (sizeof(a) == 16 && sizeof(T) == 8) return packet<T, N>::wrap(_mm_sqrt_pd((__m128d)a.v));
#endif
    packet<T, N> result = a;
    for (int lane = 0; lane < N; ++lane) result.v[lane] = std::sqrt(a.v[lane]);
    return result;
  }
}

// To the nearest integer, halves to even: adding and taking away 1.5 * 2^(mantissa bits - 1) leaves no fraction.
// |a| must stay below 2^21 (float) or 2^50 (double).
template <class T, int N>
inline packet<T, N> round(packet<T, N> a) {
  const T no_fraction = sizeof(T) == 4 ? T(0x1.8p23) : T(0x1.8p52);
  return (a + no_fraction) - no_fraction;
}

template <class T, int N>
inline packet<T, N> floor(packet<T, N> a) {
  const packet<T, N> nearest = round(a);
  return select(nearest > a, nearest - T(1), nearest);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::math
