#include "shabon/film/flow/waves.h"

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"

namespace shabon::film {

namespace {

constexpr int wave_count = 96;
constexpr double band = 4;  // longest over shortest wavelength

}  // namespace

RandomWaves::RandomWaves(std::uint64_t seed, double scale) {
  Pcg32 random(seed, 17);
  const double most = std::numbers::pi / scale;
  for (int n = 0; n < wave_count; ++n) {
    const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * std::numbers::pi);
    const double k = most * random.uniform(1 / band, 1), across = k * std::sqrt(1 - z * z);
    const math::Vec3d wave{across * std::cos(turn), across * std::sin(turn), k * z};
    waves_.push_back({wave, random.uniform(0, 2 * std::numbers::pi), 1 / k});
  }
}

double RandomWaves::value(const math::Vec3d& at) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += std::sin(math::dot(wave.k, at) + wave.phase);
  return sum * std::sqrt(2.0 / wave_count);
}

// A wave of amplitude 1/k has the mean square slope 1/2, of which a surface sees two thirds.
double RandomWaves::stream(const math::Vec3d& at) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.per_k * std::sin(math::dot(wave.k, at) + wave.phase);
  return sum * std::sqrt(3.0 / wave_count);
}

}  // namespace shabon::film
