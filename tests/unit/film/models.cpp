// What is particular to each thickness model that follows physics; what all have in common stands in thickness.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "shabon/film/thickness_field.h"

namespace shabon::film {
namespace {

using math::Vec3d;

constexpr double pi = std::numbers::pi;

Vec3d at_height(double y) { return {std::sqrt(std::max(0.0, 1 - y * y)), y, 0}; }

double nm_at(const ThicknessModel& model, double y, double seconds = 0) {
  return thickness_nm(at_time(model, seconds), at_height(y));
}

// The mean over a sphere of what depends on the height alone: over y, by Simpson's rule. The factor 1 - cos w crowds
// the places at both ends.
double mean_over_heights(const std::function<double(double)>& f) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double w = pi * i / steps, weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::sin(w) / 2 * f(std::cos(w));
  }
  return sum * pi / steps / 3;
}

TEST(EquilibriumThickness, holds_the_liquid_it_is_given) {
  for (const double squeeze : {0.0, 1e-6, 0.1, 0.5, 1.0, 5.0}) {
    EquilibriumThickness model{.mean_nm = 700};
    model.squeeze = squeeze;
    const ThicknessField field = at_time(model, 0);
    const double mean = mean_over_heights([&](double y) { return thickness_nm(field, at_height(y)); });
    EXPECT_NEAR(mean / 700, 1, 1e-9) << squeeze;
    EXPECT_NEAR(nm_at(model, -1) / nm_at(model, 1), std::exp(2 * squeeze), 1e-9 * std::exp(2 * squeeze));
  }
}

// R 5 cm, h0 1 um, E 22 mN/m: the bottom is 1.046 times as thick as the top.
TEST(EquilibriumThickness, computes_the_squeeze_of_a_bubble) {
  const EquilibriumThickness model{.mean_nm = 1000, .radius_m = 0.05};
  EXPECT_NEAR(squeeze_of(model), 1000 * 9.80665 * 0.05 * 1e-6 / 22e-3, 1e-15);
  EXPECT_NEAR(nm_at(model, -1) / nm_at(model, 1), 1.0456, 1e-4);
}

// Its limit for a small squeeze is the straight line of the same mean.
TEST(EquilibriumThickness, is_nearly_linear_when_weak) {
  EquilibriumThickness model{.mean_nm = 1000};
  model.squeeze = 1e-3;
  for (const double y : {-1.0, -0.3, 0.4, 1.0})
    EXPECT_NEAR(nm_at(model, y), nm_at(LinearThickness{999, 1001}, y), 1e-3);
}

TEST(RigidDrainage, thins_the_top_as_one_over_the_root_of_time) {
  const RigidDrainageThickness model{.start_nm = 1000, .radius_m = 0.05};
  const double tau = drainage_time_s(model);
  EXPECT_NEAR(tau, 3 * 1e-3 * 0.05 / (1000 * 9.80665 * 1e-12), 1e-6);
  // The equation of the top, dh/dt = -h^3/(2 tau) in units of the start, by fourth-order steps.
  constexpr int steps = 4000;
  double h = 1;
  const auto slope = [](double at) { return -at * at * at / 2; };
  for (int i = 1; i <= steps; ++i) {
    constexpr double dt = 5.0 / steps;
    const double a = slope(h), b = slope(h + dt / 2 * a), c = slope(h + dt / 2 * b), d = slope(h + dt * c);
    h += dt / 6 * (a + 2 * b + 2 * c + d);
    if (i % 1000 == 0) {
      EXPECT_NEAR(nm_at(model, 1, tau * i * dt) / 1000, h, 1e-9);
      EXPECT_NEAR(h, 1 / std::sqrt(1 + i * dt), 1e-9);
    }
  }
}

// h_t + (1/sin) d(sin^2 h^3)/(4 d polar) = 0, with h in units of the start and t of tau.
TEST(RigidDrainage, obeys_its_equation_on_the_whole_sphere) {
  constexpr double step = 1e-4;
  for (const double time : {0.2, 0.9, 1.0, 3.0, 50.0})
    for (double polar = 0.05; polar < 3.1; polar += 0.05) {
      const auto flow = [&](double at) { return std::pow(std::sin(at), 2) * std::pow(drained_share(at, time), 3) / 4; };
      const double thinning = (drained_share(polar, time + step) - drained_share(polar, time - step)) / (2 * step);
      const double outflow = (flow(polar + step) - flow(polar - step)) / (2 * step) / std::sin(polar);
      EXPECT_NEAR(thinning + outflow, 0, 2e-6 * (1 + std::abs(outflow))) << time << " at " << polar;
    }
}

// Before time 1 nothing has reached the bottom.
TEST(RigidDrainage, keeps_its_liquid_until_the_bottom_takes_it) {
  for (const double time : {0.1, 0.5, 0.9})
    EXPECT_NEAR(mean_over_heights([&](double y) { return drained_share(std::acos(y), time); }), 1, 1e-7) << time;
  const double later = mean_over_heights([&](double y) { return std::min(1e3, drained_share(std::acos(y), 4)); });
  EXPECT_LT(later, 0.9);
}

TEST(RigidDrainage, is_bounded_and_finds_what_it_computed) {
  const RigidDrainageThickness model{.start_nm = 800};
  for (const double time : {0.3, 1.0, 4.0, 1e4}) {
    const ThicknessField field = at_time(model, time * drainage_time_s(model));
    for (double y = -1; y <= 1; y += 0.001) {
      const double exact = std::min(drained_share(std::acos(y), time), drop_ratio) * 800;
      EXPECT_LE(thickness_nm(field, at_height(y)), 8000);
      if (y < -0.99) continue;
      EXPECT_NEAR(thickness_nm(field, at_height(y)), exact, 1e-4 * exact) << time << " " << y;
    }
  }
}

// h^2 = 4 mu zeta/(rho g t), but never thicker than at the beginning.
TEST(RigidDrainage, of_a_plane_film_is_a_parabola_below_its_top) {
  const RigidDrainageThickness model{.start_nm = 40000, .age_s = 100, .radius_m = 0.05, .plane = true};
  EXPECT_NEAR(nm_at(model, 1), 0, 1e-9);
  EXPECT_NEAR(nm_at(model, -1), 1e9 * std::sqrt(4e-3 * 0.1 / (1000 * 9.80665 * 100)), 1e-6);
  EXPECT_NEAR(nm_at(model, 0.5, 300), 1e9 * std::sqrt(4e-3 * 0.025 / (1000 * 9.80665 * 400)), 1e-6);
  EXPECT_EQ(nm_at(RigidDrainageThickness{.start_nm = 500, .plane = true}, 0.9), 500);
}

TEST(SelfSimilar, thins_everywhere_in_the_same_measure) {
  const SelfSimilarThickness model{.top_nm = 300, .bottom_nm = 1500, .half_time_s = 12, .exponent = 0.7, .age_s = 3};
  SelfSimilarThickness fresh = model;
  fresh.age_s = 0;
  EXPECT_NEAR(nm_at(fresh, 1), 300, 1e-9);
  EXPECT_NEAR(nm_at(fresh, -1), 1500, 1e-9);
  EXPECT_NEAR(nm_at(fresh, 0.3, 12) / nm_at(fresh, 0.3), 0.5, 1e-12);
  for (const double y : {-1.0, 0.0, 0.8}) {
    EXPECT_NEAR(nm_at(model, y, 40) / nm_at(model, y), nm_at(model, 1, 40) / nm_at(model, 1), 1e-12);
    EXPECT_DOUBLE_EQ(nm_at(model, y, 5), nm_at(fresh, y, 8));
  }
}

}  // namespace
}  // namespace shabon::film
