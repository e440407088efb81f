// Transport of a tracer: it keeps its mass and its bounds, comes back after a turn, and shows no imprint of the grid.
#include "shabon/film/flow/transport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "transport_cases.h"

namespace shabon::film {
namespace {

using math::Vec3d;
using test::bell;
using test::carry;

#ifndef SHABON_FLOW_LEVEL
#define SHABON_FLOW_LEVEL 4
#endif
constexpr int level = SHABON_FLOW_LEVEL;

// Axes of 0, 45 and 90 degrees from the pole, the bell on the equator of each.
const Vec3d axes[] = {{0, 0, 1}, {0, std::sqrt(0.5), std::sqrt(0.5)}, {0, 1, 0}};
const Vec3d start = {1, 0, 0};

TEST(CosineBell, ComesBackAfterATurn) {
  constexpr double gates[] = {0, 0, 0, 0.9, 0.45, 0.15, 0.04};
  double least = 1, most = 0;
  for (const Vec3d& axis : axes) {
    const auto result = carry(
        level, test::rotation_about(axis), [](const Vec3d& p) { return bell(p, start, 1.0 / 3); }, 0.5);
    EXPECT_LT(result.relative_l2, gates[level]);
    EXPECT_LT(result.mass_drift, 1e-13);
    EXPECT_GT(result.least, -1e-15);
    EXPECT_LT(result.most, 1 + 1e-13);
    least = std::min(least, result.relative_l2), most = std::max(most, result.relative_l2);
    std::printf("level %d, %d steps of Courant %.2f: L2 %.4f, mass %.1e, least %.1e, peak %.3f\n", level, result.steps,
                result.courant, result.relative_l2, result.mass_drift, result.least, result.most);
  }
  EXPECT_LT(most / least, 1.3);
}

TEST(DeformingFlow, BringsTwoBellsBackWithinTheirBounds) {
  const Vec3d one{-std::sqrt(0.75), 0.5, 0}, other{-std::sqrt(0.75), -0.5, 0};
  const auto bells = [&](const Vec3d& p) { return 0.1 + 0.9 * (bell(p, one, 0.5) + bell(p, other, 0.5)); };
  const auto result = carry(level, test::deforming, bells, 0.5);
  std::printf("level %d, %d steps: L2 %.4f, mass %.1e, within %.6f .. %.6f\n", level, result.steps, result.relative_l2,
              result.mass_drift, result.least, result.most);
  constexpr double gates[] = {0, 0, 0, 1, 0.55, 0.42, 0.2};
  EXPECT_LT(result.relative_l2, gates[level]);
  EXPECT_LT(result.mass_drift, 1e-13);
  EXPECT_GT(result.least, 0.1 - 1e-13);
  EXPECT_LT(result.most, 1 + 1e-13);
}

// A dent in a plateau: what flows up its sides must not rise above the rim.
TEST(Dent, KeepsItsRim) {
  const auto dent = [](const Vec3d& p) { return 1 - 0.9 * bell(p, start, 0.6); };
  const auto result = carry(level - 1, test::rotation_about(axes[1]), dent, 0.5);
  EXPECT_GT(result.least, 0.1 - 1e-13);
  EXPECT_LT(result.most, 1 + 1e-13);
}

// A ratio that is the same everywhere stays so in any flow, also one with sources.
TEST(Transport, KeepsAUniformRatioUniform) {
  const Metric metric(sphere_grid(3), 1);
  const SphereGrid& grid = *metric.grid;
  Transport transport(metric);
  Numbers along = grid.edge_numbers(), left = along, amount = along;
  Numbers gamma = grid.cell_numbers(1), next = gamma, h = grid.cell_numbers(7e-7), moved = h, out = gamma;
  for (int n = 0; n < 200; ++n) {
    const Vec3d pull{std::sin(0.3 * n), std::cos(0.2 * n), std::sin(0.07 * n)};
    along_edges(
        grid, [&](const Vec3d& p) { return pull * (1 + p.x * p.y); }, along);
    const double dt = 0.1 * metric.least_distance;
    for (std::size_t e = 0; e < along.size(); ++e) amount[e] = along[e] * metric.length[e] * dt;
    divergence(metric, along, out);
    for (std::size_t c = 0; c < next.size(); ++c) next[c] = gamma[c] - dt * out[c];
    transport.move({amount, along, left, dt}, gamma, next, h, moved);
    std::swap(h, moved), std::swap(gamma, next);
  }
  const auto all = gamma.values();
  EXPECT_GT(*std::max_element(all.begin(), all.end()), 1.1 * *std::min_element(all.begin(), all.end()));
  for (std::size_t c = 0; c < h.size(); ++c) ASSERT_NEAR(h[c] / gamma[c] / 7e-7, 1, 1e-12);
}

}  // namespace
}  // namespace shabon::film
