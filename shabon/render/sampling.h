// Where in a pixel each sample lies and which wavelength comb it carries: a Sobol sequence in three dimensions
// (Joe and Kuo 2008, first three dimensions). The two image dimensions are Owen-scrambled anew for every pixel with the
// hash of Laine and Karras 2011; the third is the same for all pixels, so that a plain background has no colour noise.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "shabon/base/random.h"

namespace shabon::render {

inline constexpr int comb_count = 64;  // the wavelength shifts repeat after this many samples

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = x << 16 | x >> 16;
  x = (x & 0x00FF00FFu) << 8 | (x & 0xFF00FF00u) >> 8;
  x = (x & 0x0F0F0F0Fu) << 4 | (x & 0xF0F0F0F0u) >> 4;
  x = (x & 0x33333333u) << 2 | (x & 0xCCCCCCCCu) >> 2;
  return (x & 0x55555555u) << 1 | (x & 0xAAAAAAAAu) >> 1;
}

// A cheap 32-bit mixer (Wellons 2018, "Prospecting for hash functions").
constexpr std::uint32_t mixed_bits(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352Du;
  x ^= x >> 15;
  x *= 0x846CA68Bu;
  return x ^ (x >> 16);
}

// Nested uniform scrambling of a bit-reversed number.
constexpr std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3D20ADEAu;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526C56u;
  x ^= x * 0x53A22864u;
  return x;
}

// The second Sobol dimension, bits reversed: Pascal's triangle modulo 2.
constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t v = 1u << 31; index; index >>= 1, v ^= v >> 1)
    if (index & 1) result ^= v;
  return reverse_bits(result);
}

// Direction numbers of the third dimension: primitive polynomial x^2 + x + 1, first numbers 1 and 3.
constexpr std::array<std::uint32_t, 32> third_directions() {
  std::array<std::uint32_t, 32> v{1u << 31, 3u << 30};
  for (std::size_t i = 2; i < v.size(); ++i) v[i] = v[i - 1] ^ v[i - 2] ^ (v[i - 2] >> 2);
  return v;
}

// The wavelength comb of sample `index`: the leading bits of the third Sobol dimension. Every aligned block of 2^m
// samples, m <= 6, spreads its combs evenly.
constexpr int comb_of_sample(std::uint32_t index) {
  constexpr auto direction = third_directions();
  constexpr int comb_bits = std::countr_zero(static_cast<unsigned>(comb_count));
  std::uint32_t result = 0;
  for (std::size_t bit = 0; index >> bit; ++bit) {
    if (index >> bit & 1) result ^= direction[bit];
    if (bit == 31) break;
  }
  return static_cast<int>(result >> (32 - comb_bits));
}

struct PixelSeeds {
  std::uint32_t x, y;
};

constexpr PixelSeeds pixel_seeds(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y) {
  const std::uint64_t h = hash64(hash64(seed), static_cast<std::uint64_t>(pixel_y) << 32 | pixel_x);
  return {static_cast<std::uint32_t>(h), static_cast<std::uint32_t>(h >> 32)};
}

// The place of sample `index` in a pixel, each coordinate in [0, 1).
constexpr float pixel_offset_x(std::uint32_t index, std::uint32_t seed) {
  return unit_float(reverse_bits(scrambled_reversed(index, seed)));
}
constexpr float pixel_offset_y(std::uint32_t second_reversed, std::uint32_t seed) {
  return unit_float(reverse_bits(scrambled_reversed(second_reversed, seed)));
}

}  // namespace shabon::render
