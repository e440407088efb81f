// Random numbers that are the same on every machine: hashes and a PCG32 stream (O'Neill 2014, pcg-random.org,
// "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms"). std:: distributions differ between
// libraries and are not used.
#pragma once

#include <cstdint>

namespace shabon {

// A well-mixed 64-bit hash (SplitMix64's finaliser: Steele, Lea, Flood 2014).
constexpr std::uint64_t hash64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

constexpr std::uint64_t hash64(std::uint64_t a, std::uint64_t b) { return hash64(hash64(a) ^ b); }

// A number in [0, 1) from the upper 24 bits: every value is exact in float.
constexpr float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }
constexpr double unit_double(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

class Pcg32 {
 public:
  constexpr explicit Pcg32(std::uint64_t seed, std::uint64_t stream = 0) : increment_(stream << 1 | 1) {
    (*this)();
    state_ += seed;
    (*this)();
  }
  constexpr std::uint32_t operator()() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + increment_;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return mixed >> turn | mixed << (-turn & 31);
  }
  constexpr double uniform() {  // [0, 1)
    const std::uint64_t high = (*this)();
    return unit_double(high << 32 | (*this)());
  }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
};

}  // namespace shabon
