#include "transport_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::film::test {

using math::Vec3d;
using std::numbers::pi;

Stream rotation_about(const Vec3d& axis) {
  return [axis](const Vec3d& at, double) { return -2 * pi * math::dot(at, axis); };
}

double deforming(const Vec3d& at, double time) {
  constexpr double period = 5, strength = 2;  // of the paper, in radii
  const double angle = 2 * pi * time;
  const double y = at.y * std::cos(angle) - at.x * std::sin(angle);  // cos(latitude) sin(longitude - angle)
  return period * strength * y * y * std::cos(pi * time) - 2 * pi * at.z;
}

double bell(const Vec3d& at, const Vec3d& centre, double r) {
  const double distance = std::acos(std::clamp(math::dot(at, centre), -1.0, 1.0));
  return distance < r ? (1 + std::cos(pi * distance / r)) / 2 : 0;
}

Carried carry(int level, const Stream& stream, const Profile& profile, double courant) {
  const Metric metric(sphere_grid(level), 1);
  const SphereGrid& grid = *metric.grid;
  Transport transport(metric);
  Numbers psi = grid.triangle_numbers(), along = grid.edge_numbers(), left = along, amount = along;
  Numbers kinetic = grid.cell_numbers(), carrier = grid.cell_numbers(1);
  Padded<float> turned = grid.slot_numbers();
  Numbers h = grid.cell_numbers(), moved = h;
  const auto flow_at = [&](double time) {
    for (std::size_t t = 0; t < psi.size(); ++t) psi[t] = stream(grid.corners[t], time);
    from_stream(metric, psi, along);
  };
  const auto fastest = [&] {
    double most = 0;
    for (std::size_t e = 0; e < along.size(); ++e) most = std::max(most, std::abs(along[e]) / metric.distance[e]);
    return most;
  };
  double most_speed = 0;
  for (int i = 0; i <= 8; ++i) flow_at(i / 8.0), most_speed = std::max(most_speed, fastest());
  Carried result;
  result.steps = static_cast<int>(std::ceil(most_speed / courant));
  const double dt = 1.0 / result.steps;
  for (std::size_t c = 0; c < h.size(); ++c) h[c] = profile(grid.centres[c]);
  const Numbers start = h;
  const double mass = integral(metric, h);
  result.least = 1e300, result.most = -1e300;
  for (int n = 0; n < result.steps; ++n) {
    flow_at((n + 0.5) * dt);
    result.courant = std::max(result.courant, fastest() * dt);
    cell_terms(metric, along, kinetic, turned);
    across(metric, turned, left);
    for (std::size_t e = 0; e < along.size(); ++e) amount[e] = along[e] * metric.length[e] * dt;
    transport.move({amount, along, left, dt}, carrier, carrier, h, moved);
    std::swap(h, moved);
    const auto [low, high] = std::minmax_element(h.values().begin(), h.values().end());
    result.least = std::min(result.least, *low), result.most = std::max(result.most, *high);
  }
  result.mass_drift = std::abs(integral(metric, h) / mass - 1);
  double difference = 0, norm = 0;
  for (std::size_t c = 0; c < h.size(); ++c) {
    difference += metric.area[c] * (h[c] - start[c]) * (h[c] - start[c]);
    norm += metric.area[c] * start[c] * start[c];
  }
  result.relative_l2 = std::sqrt(difference / norm);
  return result;
}

}  // namespace shabon::film::test
