#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/film/thickness_field.h"

namespace shabon::film {
namespace {

using math::Vec3d;

NoiseThickness on_constant(double nm) {
  NoiseThickness model;
  model.base = BaseThickness{ConstantThickness{nm}};
  return model;
}

// Evenly over the unit sphere: equal steps of height, the golden angle between one and the next.
Vec3d spiral(int i, int count) {
  const double y = 1 - (2 * i + 1.0) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double across = std::sqrt(1 - y * y);
  return {across * std::cos(turn), y, across * std::sin(turn)};
}

TEST(Noise, has_mean_0_and_deviation_1_in_space) {
  for (const double scale : {0.05, 0.5, 2.0}) {
    NoiseThickness model = on_constant(500);
    model.scale = scale;
    const NoiseWaves waves = noise_waves(model);
    Pcg32 random(7);
    constexpr int count = 40000;
    double sum = 0, squares = 0, fourths = 0;
    for (int i = 0; i < count; ++i) {
      const Vec3d at{random.uniform(-99, 99), random.uniform(-99, 99), random.uniform(-99, 99)};
      const double value = noise_at(waves, at) + waves.mean;
      sum += value, squares += value * value, fourths += value * value * value * value;
    }
    EXPECT_NEAR(sum / count, 0, 0.03);
    EXPECT_NEAR(squares / count, 1, 0.03);
    EXPECT_NEAR(fourths / count, 3, 0.25);  // the bell curve's
  }
}

TEST(Noise, leaves_the_mean_thickness_of_a_bubble) {
  for (const int octaves : {1, 3, 8}) {
    NoiseThickness model = on_constant(500);
    model.octaves = octaves, model.stretch = octaves == 3 ? 4 : 1;
    const NoiseWaves waves = noise_waves(model);
    constexpr int count = 200000;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += noise_at(waves, spiral(i, count));
    EXPECT_NEAR(sum / count, 0, 5e-5) << octaves;
  }
}

TEST(Noise, has_no_waves_but_those_of_its_octaves) {
  NoiseThickness model = on_constant(500);
  model.scale = 0.4, model.octaves = 5;
  double sum = 0;
  for (const Wave& wave : noise_waves(model).waves) {
    const double length = 1 / std::hypot(wave.x, wave.y, wave.z);
    EXPECT_LE(length, 0.4 * (1 + 1e-12));
    EXPECT_GE(length, 0.4 / 32 * (1 - 1e-12));
    sum += wave.amplitude * wave.amplitude / 2;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(Noise, keeps_its_coarse_waves_when_finer_ones_are_added) {
  NoiseThickness coarse = on_constant(500), fine = coarse;
  coarse.octaves = 2, fine.octaves = 4;
  const auto few = noise_waves(coarse).waves, many = noise_waves(fine).waves;
  ASSERT_LT(few.size(), many.size());
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].x, many[i].x);
    EXPECT_EQ(few[i].phase, many[i].phase);
  }
}

TEST(Noise, is_another_one_for_another_seed_and_the_same_for_the_same) {
  NoiseThickness model = on_constant(500);
  const double first = thickness_nm(at_time(model, 0), spiral(3, 10));
  EXPECT_EQ(first, thickness_nm(at_time(model, 9), spiral(3, 10)));
  model.seed = 2;
  EXPECT_GT(std::abs(first - thickness_nm(at_time(model, 0), spiral(3, 10))), 1);
}

TEST(Noise, varies_faster_in_height_when_flattened) {
  const auto slopes = [](double stretch) {
    NoiseThickness model = on_constant(500);
    model.stretch = stretch, model.octaves = 1, model.scale = 1;
    const NoiseWaves waves = noise_waves(model);
    double up = 0, along = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3d at = spiral(i, 2000);
      up += std::pow(noise_at(waves, at + Vec3d{0, 1e-4, 0}) - noise_at(waves, at), 2);
      along += std::pow(noise_at(waves, at + Vec3d{1e-4, 0, 0}) - noise_at(waves, at), 2);
    }
    return std::sqrt(up / along);
  };
  const double round = slopes(1), flat = slopes(6);
  EXPECT_NEAR(flat / round, 6, 1);
}

TEST(Noise, is_dragged_without_losing_its_deviation) {
  NoiseThickness model = on_constant(500);
  model.swirl = 1;
  const NoiseWaves waves = noise_waves(model);
  double sum = 0, squares = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double value = noise_at(waves, spiral(i, count) * 20.0);
    sum += value, squares += value * value;
  }
  EXPECT_NEAR(sum / count, 0, 0.05);
  EXPECT_NEAR(squares / count, 1, 0.1);
}

TEST(Noise, lies_on_whatever_is_below_it) {
  NoiseThickness fine, model = on_constant(500);
  model.amplitude = 0.1, model.seed = 5;
  fine.base = BaseThickness{model};
  fine.amplitude = 0.05, fine.seed = 6, fine.scale = 0.1;
  for (int i = 0; i < 50; ++i) {
    const Vec3d at = spiral(i, 50);
    const double coarse = 1 + 0.1 * noise_at(noise_waves(model), at), more = 1 + 0.05 * noise_at(noise_waves(fine), at);
    EXPECT_NEAR(thickness_nm(at_time(fine, 0), at), 500 * coarse * more, 1e-9);
  }
  NoiseThickness draining;
  draining.base = BaseThickness{SelfSimilarThickness{.half_time_s = 5}};
  const double before = thickness_nm(at_time(draining, 0), spiral(4, 9));
  EXPECT_NEAR(thickness_nm(at_time(draining, 5), spiral(4, 9)) / before, 0.5, 1e-12);
}

TEST(Noise, never_makes_less_than_nothing) {
  NoiseThickness model = on_constant(500);
  model.amplitude = 1;
  const ThicknessField field = at_time(model, 0);
  double least = 1e9;
  for (int i = 0; i < 5000; ++i) least = std::min(least, thickness_nm(field, spiral(i, 5000)));
  EXPECT_EQ(least, 0);
}

}  // namespace
}  // namespace shabon::film
