// The shape in time: modes and popping against known numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/film/popping.h"
#include "shabon/film/shape_modes.h"

namespace shabon::film {
namespace {

using math::Vec3d;
using std::numbers::pi;

BubbleBody body_of(double radius_m, double thickness_m) {
  BubbleBody body;
  body.radius_m = radius_m;
  body.thickness_m = thickness_m;
  return body;
}

TEST(ShapeModes, TrembleAtTheirFrequency) {
  // sqrt(0.2 / (6.25e-4 0.026)) / (2 pi)
  EXPECT_NEAR(shape_frequency_rad_s(body_of(0.025, 1e-6), 2) / (2 * pi), 17.6567, 1e-3);
  EXPECT_NEAR(shape_frequency_rad_s(body_of(0.05, 1e-6), 2) / (2 * pi), 6.3, 0.05);
  EXPECT_EQ(shape_frequency_rad_s(body_of(0.05, 1e-6), 1), 0);
  EXPECT_EQ(shape_frequency_rad_s(body_of(0.05, 1e-6), 0), 0);
}

// Without film: Lamb's drop and bubble of one surface with twice the tension, 2 T l (l-1)(l+1)(l+2) / (r^3 (..)).
TEST(ShapeModes, AreLambsWithoutMass) {
  BubbleBody body = body_of(0.02, 0);
  body.inner_air_kg_m3 = 3, body.outer_air_kg_m3 = 1.5;
  for (int l = 2; l < 9; ++l) {
    const double lamb =
        2 * body.tension_n_m * l * (l - 1) * (l + 1) * (l + 2) / (std::pow(body.radius_m, 3) * ((l + 1) * 3 + l * 1.5));
    EXPECT_NEAR(std::pow(shape_frequency_rad_s(body, l), 2) / lamb, 1, 1e-12) << l;
  }
}

TEST(ShapeModes, KeepTheVolume) {
  const BubbleBody body = body_of(0.03, 1e-6);
  const std::vector<ShapeMode> modes = {{.degree = 2, .amplitude_m = 1.5e-3}, {.degree = 5, .amplitude_m = 6e-4}};
  double volume = 0, at_pole = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double z = -1 + (i + 0.5) * 2 / steps;
    volume += 2 * pi / 3 * std::pow(radius_m(body, modes, {std::sqrt(1 - z * z), z, 0}, 0), 3) * 2 / steps;
    at_pole = std::max(at_pole, radius_m(body, modes, {0, 1, 0}, 0));
  }
  EXPECT_NEAR(at_pole, 0.0321, 1e-4);
  EXPECT_NEAR(volume / (4 * pi / 3 * std::pow(0.03, 3)), 1, 2e-4);
}

TEST(ShapeModes, SwingAndDieDown) {
  const BubbleBody body = body_of(0.03, 1e-6);
  const std::vector<ShapeMode> mode = {{.degree = 3, .amplitude_m = 1e-3, .quality = 10}};
  const double frequency = shape_frequency_rad_s(body, 3), damped = frequency * std::sqrt(1 - 1 / 400.0);
  const auto height = [&](double t) { return radius_m(body, mode, {0, 1, 0}, t) - 0.03; };
  EXPECT_NEAR(height(0), 1e-3, 5e-6);
  EXPECT_NEAR(height(pi / damped) / -1e-3, std::exp(-pi / (20 * damped / frequency)), 0.01);
  EXPECT_LT(std::abs(height(10 * 2 * pi / frequency)), 5e-5);
}

TEST(Popping, RunsAtTaylorsAndCulicksSpeed) {
  EXPECT_NEAR(taylor_culick_m_s(25e-3, 1000, 1e-6), 7.07, 0.007);
  EXPECT_NEAR(popping_duration_s(body_of(0.05, 1e-6), {}), 0.0222, 1e-4);
  EXPECT_NEAR(popping_duration_s(body_of(0.05, 1e-6), {.slow_motion = 100}), 2.22, 1e-2);
}

TEST(Popping, GathersTheFilmInItsRim) {
  const BubbleBody body = body_of(0.05, 1e-6);
  const PoppingDesc popping{.start_s = 1};
  const double all = 4 * pi * 0.05 * 0.05 * 1e-6;
  EXPECT_EQ(hole_at(body, popping, 0.5).angle_rad, 0);
  EXPECT_EQ(hole_at(body, popping, 0.5).rim_volume_m3, 0);
  const Hole half = hole_at(body, popping, 1 + popping_duration_s(body, popping) / 2);
  EXPECT_NEAR(half.angle_rad, pi / 2, 1e-9);
  EXPECT_NEAR(half.rim_volume_m3 / all, 0.5, 1e-9);
  EXPECT_NEAR(2 * pi * 0.05 * pi * half.rim_radius_m * half.rim_radius_m / all, 0.5, 1e-9);
  const Hole gone = hole_at(body, popping, 2);
  EXPECT_NEAR(gone.angle_rad, pi, 1e-12);
  EXPECT_NEAR(gone.rim_volume_m3 / all, 1, 1e-9);
}

}  // namespace
}  // namespace shabon::film
