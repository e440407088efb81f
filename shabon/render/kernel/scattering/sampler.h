// Random numbers for surfaces that scatter: at each choice of each path two or more numbers of a Sobol sequence over
// the samples of the pixel, scrambled and shuffled anew for every choice (Burley 2020, "Practical hash-based Owen
// scrambling"): every choice is spread as evenly over the samples as the pixel's points are.
#pragma once

#include "shabon/render/sampling.h"

namespace shabon::render {

struct SamplePair {
  double first, second;
};

// The pair of sample `index` for a choice that `key` names.
constexpr SamplePair sample_pair(std::uint32_t index, std::uint32_t key) {
  const std::uint32_t shuffle = mixed_bits(key), first = mixed_bits(key ^ 0x51633E2Du),
                      second = mixed_bits(first + key);
  const std::uint32_t at = reverse_bits(scrambled_reversed(reverse_bits(index), shuffle));
  const std::uint32_t x = reverse_bits(scrambled_reversed(at, first));
  const std::uint32_t y = reverse_bits(scrambled_reversed(sobol_second_reversed(at), second));
  return {unit_float(x), unit_float(y)};
}

// The one number of sample `index` for a choice that `key` names.
constexpr double sample_number(std::uint32_t index, std::uint32_t key) { return sample_pair(index, key).first; }

}  // namespace shabon::render
