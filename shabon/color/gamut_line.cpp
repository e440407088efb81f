#include "shabon/color/gamut_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shabon/color/oklab.h"

namespace shabon::color {

namespace {

constexpr Vector3 lightness_weights = cone_roots_to_oklab[0];
constexpr double weight_sum = lightness_weights[0] + lightness_weights[1] + lightness_weights[2];
constexpr double never = std::numeric_limits<double>::infinity();

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The first t > 0 at which inside + 2 half_slope t + curvature t^2 falls to 0, starting from inside > 0.
double first_exit(double inside, double half_slope, double curvature) {
  const double discriminant = half_slope * half_slope - curvature * inside;
  if (discriminant < 0) return never;
  const double divisor = std::sqrt(discriminant) - half_slope;
  return divisor > 0 ? inside / divisor : never;
}

// Red, yellow, green, cyan, blue, magenta: the edges between neighbours hold the strongest colours of every hue.
constexpr std::array<Vector3, 6> corners{Vector3{1, 0, 0}, Vector3{1, 1, 0}, Vector3{0, 1, 0},
                                         Vector3{0, 1, 1}, Vector3{0, 0, 1}, Vector3{1, 0, 1}};

RootColor on_edge(std::size_t edge, double share) {
  const Vector3 &from = corners[edge], &to = corners[(edge + 1) % corners.size()];
  Vector3 colour;
  for (std::size_t k = 0; k < 3; ++k) colour[k] = from[k] + share * (to[k] - from[k]);
  return root_color(colour);
}

// Positive where the colour's hue lies clockwise of (a, b).
double clockwise_of(const RootColor& colour, double a, double b) { return colour.a * b - colour.b * a; }

const std::array<RootColor, 6>& corner_colors() {
  static const std::array<RootColor, 6> colors = [] {
    std::array<RootColor, 6> result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = root_color(corners[i]);
    return result;
  }();
  return colors;
}

}  // namespace

RootColor root_color(const Vector3& linear_srgb) {
  RootColor colour;
  colour.roots = multiply(srgb_to_cones, linear_srgb);
  for (double& v : colour.roots) v = std::copysign(std::sqrt(std::abs(v)), v);
  colour.lightness = dot(lightness_weights, colour.roots) / weight_sum;
  colour.a = dot(cone_roots_to_oklab[1], colour.roots);
  colour.b = dot(cone_roots_to_oklab[2], colour.roots);
  colour.chroma = std::hypot(colour.a, colour.b);
  return colour;
}

double cusp_lightness(double a, double b) {
  const std::array<RootColor, 6>& all = corner_colors();
  std::size_t edge = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool between = clockwise_of(all[i], a, b) >= 0 && clockwise_of(all[(i + 1) % all.size()], a, b) < 0;
    if (between && all[i].a * a + all[i].b * b > -all[i].chroma * std::hypot(a, b) / 2) edge = i;
  }
  // The root of the cross product by regula falsi, where an end that stays put twice is halved (the "Illinois" rule).
  double low = 0, high = 1, at_low = clockwise_of(all[edge], a, b),
         at_high = clockwise_of(all[(edge + 1) % all.size()], a, b);
  constexpr int most_steps = 20;
  constexpr double enough = 1e-15;  // of the corner's own cross product
  const double scale = at_low - at_high;
  double share = 0;
  int moved = 0;  // -1: the low end last, 1: the high end
  for (int i = 0; i < most_steps && scale > 0; ++i) {
    share = low + (high - low) * at_low / (at_low - at_high);
    const double here = clockwise_of(on_edge(edge, share), a, b);
    if (std::abs(here) <= enough * scale) break;
    if (here > 0) {
      low = share, at_low = here;
      if (moved < 0) at_high /= 2;
      moved = -1;
    } else {
      high = share, at_high = here;
      if (moved > 0) at_low /= 2;
      moved = 1;
    }
  }
  return on_edge(edge, share).lightness;
}

GamutLine::GamutLine(const RootColor& colour, double grey_lightness) : grey_(grey_lightness * grey_lightness) {
  Vector3 away, away_squared;
  for (std::size_t i = 0; i < 3; ++i) {
    away[i] = colour.roots[i] - grey_lightness;
    away_squared[i] = away[i] * away[i];
  }
  slope_ = multiply(cones_to_srgb, away);
  for (double& slope : slope_) slope *= grey_lightness;
  curve_ = multiply(cones_to_srgb, away_squared);
}

double GamutLine::exit() const {
  double t = never;
  for (std::size_t k = 0; k < 3; ++k)
    t = std::min({t, first_exit(grey_, slope_[k], curve_[k]), first_exit(1 - grey_, -slope_[k], -curve_[k])});
  return t;
}

Vector3 GamutLine::at(double t) const {
  Vector3 colour;
  for (std::size_t k = 0; k < 3; ++k) colour[k] = grey_ + t * (2 * slope_[k] + t * curve_[k]);
  return colour;
}

}  // namespace shabon::color
