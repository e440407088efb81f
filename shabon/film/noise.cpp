#include "shabon/film/noise.h"

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/film/thickness_field.h"

namespace shabon::film {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int waves_per_octave = 32, waves_per_swirl = 12;

// Waves of random directions and phases, their lengths spread evenly in proportion over an octave below `longest`. The
// sum's standard deviation in space is `deviation`.
void add_octave(std::vector<Wave>& waves, Pcg32 random, int count, double longest, double stretch, double deviation) {
  const double amplitude = deviation * std::sqrt(2.0 / count);
  for (int i = 0; i < count; ++i) {
    const double k = std::exp2((i + random.uniform()) / count) / longest;
    const double y = random.uniform(-1, 1), turn = 2 * pi * random.uniform(), across = std::sqrt(1 - y * y);
    waves.push_back(
        {k * across * std::cos(turn), k * y * stretch, k * across * std::sin(turn), random.uniform(), amplitude});
  }
}

// Of one wave over the unit sphere: cos(phase) sin(k)/k.
double mean_over_sphere(const Wave& wave) {
  const double k = 2 * pi * std::hypot(wave.x, wave.y, wave.z);
  return wave.amplitude * std::cos(2 * pi * wave.phase) * std::sin(k) / k;
}

}  // namespace

NoiseWaves noise_waves(const NoiseThickness& model) {
  NoiseWaves noise;
  double variance = 0;
  for (int octave = 0; octave < model.octaves; ++octave) variance += std::pow(model.roughness, 2 * octave);
  // Each octave has random numbers of its own: more octaves leave the first ones as they were.
  for (int octave = 0; octave < model.octaves; ++octave) {
    const double deviation = std::pow(model.roughness, octave) / std::sqrt(variance);
    const Pcg32 random(hash64(model.seed), static_cast<std::uint64_t>(octave));
    if (deviation > 0)
      add_octave(noise.waves, random, waves_per_octave, model.scale * std::exp2(-octave), model.stretch, deviation);
  }
  for (const Wave& wave : noise.waves) noise.mean += mean_over_sphere(wave);
  if (model.swirl == 0) return noise;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Pcg32 random(hash64(model.seed), 100 + axis);
    const double drag = model.swirl * model.scale * (axis == 1 ? 1 / std::max(1.0, model.stretch) : 1.0);
    add_octave(noise.swirls[axis], random, waves_per_swirl, 2 * model.scale, 1, drag / std::sqrt(3.0));
  }
  return noise;
}

NoiseField prepared(const NoiseThickness& model, double seconds) {
  return {HeldField{at_time(model.base->model, seconds)}, model.amplitude,
          std::make_shared<const NoiseWaves>(noise_waves(model))};
}

}  // namespace shabon::film
