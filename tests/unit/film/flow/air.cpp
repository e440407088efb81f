// What moves the air, and the random fields behind it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/film/flow/air_field.h"
#include "shabon/film/flow/waves.h"

namespace shabon::film {
namespace {

using math::Vec3d;

const Metric metric(sphere_grid(4), 0.05);

Numbers at(AirMotion motion, double time_s, std::uint64_t seed = 1) {
  return AirField(metric, {std::move(motion)}, seed).at(time_s);
}

double root_mean_square_speed(const Numbers& along) {
  double energy = 0, area = 0;
  for (std::size_t e = 0; e < along.size(); ++e) {
    const double share = metric.length[e] * metric.distance[e];
    energy += share * along[e] * along[e], area += share;
  }
  return std::sqrt(2 * energy / area);
}

double fastest(const Numbers& along) {
  double most = 0;
  for (const double u : along.values()) most = std::max(most, std::abs(u));
  return most;
}

TEST(AirEnvelope, RisesAndFallsSmoothly) {
  const AirEnvelope envelope{.start_s = 1, .duration_s = 3, .ramp_s = 0.5};
  EXPECT_EQ(share_at(envelope, 0.99), 0);
  EXPECT_EQ(share_at(envelope, 1), 0);
  EXPECT_DOUBLE_EQ(share_at(envelope, 1.25), 0.5);
  EXPECT_EQ(share_at(envelope, 2.5), 1);
  EXPECT_DOUBLE_EQ(share_at(envelope, 3.75), 0.5);
  EXPECT_EQ(share_at(envelope, 4.01), 0);
  EXPECT_EQ(share_at({.ramp_s = 0}, 0), 1);
}

TEST(AirRotation, TurnsAboutItsAxis) {
  const Numbers along = at(AirRotation{.axis = {0, 0, 2}, .speed_m_s = 0.4}, 1);
  Numbers exact = along;
  along_edges(
      *metric.grid,
      [](const Vec3d& p) {
        return math::cross(Vec3d{0, 0, 0.4}, p);
      },
      exact);
  for (std::size_t e = 0; e < along.size(); ++e) EXPECT_NEAR(along[e], exact[e], 1e-14);
  EXPECT_NEAR(fastest(along), 0.4, 0.01);
}

TEST(AirJet, IsStrongestAtItsPlaceAndGoneBehind) {
  const Numbers along = at(AirJet{.place = {0, 0, 3}, .direction = {0, 2, 0}, .speed_m_s = 1.5}, 1);
  const auto velocity = cell_vectors(metric, along);
  EXPECT_NEAR(fastest(along), 1.5, 0.05);
  for (std::size_t c = 0; c < velocity.size(); ++c) {
    const double z = metric.grid->centres[c].z;
    if (z > 0.999) {
      EXPECT_NEAR(velocity[c].y, 1.5, 0.05);
    } else if (z < -0.5) {
      EXPECT_LT(math::length(velocity[c]), 0.01);
    }
  }
}

TEST(AirSwirls, HaveNoSourcesAndTheirSpeed) {
  double speed = 0;
  constexpr int seeds = 12;
  for (int seed = 0; seed < seeds; ++seed) {
    const Numbers along = at(AirSwirls{.speed_m_s = 0.3, .scale_m = 0.015, .change_s = 4}, 2, seed);
    Numbers out = metric.grid->cell_numbers();
    divergence(metric, along, out);
    EXPECT_LT(fastest(out), 1e-11);
    speed += root_mean_square_speed(along) / seeds;
  }
  EXPECT_NEAR(speed, 0.3, 0.03);
}

TEST(AirSwirls, ComeBack) {
  const AirSwirls swirls{.change_s = 4, .envelope = {.ramp_s = 0}};
  const Numbers first = at(swirls, 0.5), later = at(swirls, 4.5), other = at(swirls, 1.5);
  double same = 0, different = 0;
  for (std::size_t e = 0; e < first.size(); ++e) {
    same = std::max(same, std::abs(first[e] - later[e]));
    different = std::max(different, std::abs(first[e] - other[e]));
  }
  EXPECT_LT(same, 1e-12);
  EXPECT_GT(different, 0.1);
}

// A field asked for in steps is the field asked for at once: nothing depends on what was asked before.
TEST(AirGusts, DependOnTheTimeAlone) {
  const AirGusts gusts{.rate_per_s = 5, .speed_m_s = 1.6, .length_s = 0.5};
  AirField stepped(metric, {gusts}, 7);
  double most = 0;
  for (int n = 0; n <= 300; ++n) most = std::max(most, fastest(stepped.at(0.01 * n)));
  EXPECT_GT(most, 0.7);
  EXPECT_LT(most, 3 * 1.6);
  const Numbers at_once = at(gusts, 0.01 * 300, 7);
  const Numbers& in_steps = stepped.at(0.01 * 300);
  for (std::size_t e = 0; e < at_once.size(); ++e) EXPECT_EQ(at_once[e], in_steps[e]);
  EXPECT_GT(fastest(at_once), 0);
}

TEST(RandomWaves, HaveUnitVariance) {
  double sum = 0, squares = 0;
  constexpr int seeds = 40, places = 200;
  for (int seed = 0; seed < seeds; ++seed) {
    const RandomWaves waves(static_cast<std::uint64_t>(seed), 0.01);
    for (int i = 0; i < places; ++i) {
      const double value = waves.value({0.37 * i, 0.11 * i * i, -0.2 * i});
      sum += value, squares += value * value;
    }
  }
  EXPECT_NEAR(sum / (seeds * places), 0, 0.05);
  EXPECT_NEAR(squares / (seeds * places), 1, 0.05);
}

}  // namespace
}  // namespace shabon::film
