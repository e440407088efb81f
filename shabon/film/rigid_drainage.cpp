#include "shabon/film/rigid_drainage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace shabon::film {

namespace {

constexpr double pi = std::numbers::pi;

// Gauss-Legendre, 16 points, the positive half (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 8> nodes = {0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                         0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                         0.9445750230732326, 0.9894009349916499};
constexpr std::array<double, 8> weights = {0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                           0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                           0.0622535239386479, 0.0271524594117541};

// The integral of sin^(1/3) from 0 to `angle`, 0..pi/2. With angle = v^3 the integrand has no root at 0.
double quarter_path(double angle) {
  const double v_end = std::cbrt(angle), half = v_end / 2;
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const double node : {-nodes[i], nodes[i]}) {
      const double v = half * (1 + node);
      sum += weights[i] * 3 * v * v * std::cbrt(std::sin(v * v * v));
    }
  return half * sum;
}

// The same for `angle` of 0..pi: S of (65).
double path(double angle) {
  static const double whole = 2 * quarter_path(pi / 2);
  return angle <= pi / 2 ? quarter_path(angle) : whole - quarter_path(pi - angle);
}

// Where the liquid at `polar` was at time 0: the root of S(x) + 3/4 time sin^(4/3) x = S(polar). The left side rises
// up to cos x = -1/time; what started beyond has reached the bottom.
double start_of(double polar, double time) {
  const double target = path(polar);
  double low = 0, high = time > 1 ? std::min(polar, std::acos(-1 / time)) : polar;
  double x = std::min(high, polar / std::pow(1 + time, 0.75));  // exact near the top
  for (int step = 0; step < 100; ++step) {
    const double sine = std::sin(x), root = std::cbrt(sine);
    const double excess = path(x) + 0.75 * time * sine * root - target;
    (excess > 0 ? high : low) = x;
    const double slope = root * (1 + time * std::cos(x));
    double next = slope > 0 ? x - excess / slope : low - 1;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - x) <= 1e-15 * x || high - low <= 1e-15 * high) return next;
    x = next;
  }
  return x;
}

}  // namespace

double drainage_time_s(const RigidDrainageThickness& model) {
  const double start_m = model.start_nm * 1e-9;
  return 3 * model.viscosity_pa_s * model.radius_m / (model.density_kg_m3 * standard_gravity_m_s2 * start_m * start_m);
}

double drained_share(double polar, double time) {
  // Nearer to a pole than this the limits there are exact to the last digit.
  constexpr double pole = 1e-7;
  if (time <= 0) return 1;
  if (polar < pole) return 1 / std::sqrt(1 + time);
  if (pi - polar < pole) return time < 1 ? 1 / std::sqrt(1 - time) : std::numeric_limits<double>::infinity();
  return std::pow(std::sin(start_of(polar, time)) / std::sin(polar), 2.0 / 3);
}

DrainedThickness prepared(const RigidDrainageThickness& model, double seconds) {
  constexpr int steps = 2048;
  const double age_s = std::max(0.0, model.age_s + seconds);
  DrainedThickness film{model.start_nm, nullptr, 0};
  if (model.plane) {
    const double drained_m2 = 4 * model.viscosity_pa_s * model.radius_m /
                              (model.density_kg_m3 * standard_gravity_m_s2 * std::max(age_s, 1e-9));
    film.nm_at_half_height = std::sqrt(drained_m2) * 1e9;
    return film;
  }
  const double time = model.start_nm > 0 ? age_s / drainage_time_s(model) : 0;
  auto table = std::make_shared<std::vector<double>>();
  for (int i = 0; i <= steps; ++i) {
    const double polar = pi - 2 * std::asin(static_cast<double>(i) / steps);
    const double share = std::min(drained_share(std::max(0.0, polar), time), drop_ratio);
    table->push_back(std::min(model.start_nm * share, thickness_range_nm.high));
  }
  film.nm = std::move(table);
  return film;
}

}  // namespace shabon::film
