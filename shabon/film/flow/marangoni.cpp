#include "shabon/film/flow/marangoni.h"

#include <cmath>

#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

namespace {

constexpr double dilatational = 4;  // Trapeznikov: the film's viscosity against stretching over that against shear

}  // namespace

Marangoni::Marangoni(const Metric& metric, const FilmForces& forces, const math::Vec3d& gravity_m_s2)
    : metric_(metric),
      forces_(forces),
      gravity_(metric.grid->edge_numbers()),
      free_(gravity_),
      coupling_(gravity_),
      guess_(metric.grid->cell_numbers()),
      right_(guess_),
      solver_(metric) {
  Numbers potential = guess_;
  for (std::size_t c = 0; c < potential.size(); ++c)
    potential[c] = metric.radius * math::dot(gravity_m_s2, metric.grid->centres[c]);
  gradient(metric, potential, gravity_);
}

// What would cross each edge without elasticity, and by how much a difference of surfactant changes it.
void Marangoni::assemble(const Before& before, double step_s) {
  const double *h = before.thickness.data(), *gamma = before.surfactant.data(), *last = before.surfactant_last.data();
  const double *u = before.along.data(), *wind = before.air.data(), *gravity = gravity_.data();
  const double *length = metric_.length.data(), *per_distance = metric_.per_distance.data();
  double *flux = free_.data(), *coupling = coupling_.data();
  const double half_density = forces_.density_kg_m3 / 2, drag = forces_.drag_kg_m2_s * step_s;
  const double pull = forces_.elasticity_n_m * step_s, stretch = dilatational * forces_.viscosity_m2_s;
  sweep_owners(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>(), n = a.template cell<k>();
      const double mass = half_density * (h[c] + h[n]), amount = 0.5 * (gamma[c] + gamma[n]);
      const double ease = 1 / (mass + drag), cross = step_s * length[e];
      const double slope = (gamma[n] - gamma[c]) * per_distance[e];
      const double moved = amount * (mass * (u[e] + step_s * gravity[e]) + drag * wind[e]) + stretch * mass * slope;
      flux[e] = cross * ease * moved;
      coupling[e] = cross * per_distance[e] * ease * (pull * amount + stretch * mass);
    });
  });
  const double* area = metric_.area.data();
  double *right = right_.data(), *guess = guess_.data();
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    double out = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      out += a.template sign<k>() * flux[a.template edge<k>()];
    });
    right[c] = area[c] * gamma[c] - out;
    guess[c] = 2 * gamma[c] - last[c];
  });
}

void Marangoni::commit(const Before& before, double step_s, const After& after) {
  const double *gamma = before.surfactant.data(), *next = guess_.data();
  const double *flux = free_.data(), *coupling = coupling_.data();
  const double *per_length = metric_.per_length.data(), *per_area = metric_.per_area.data();
  double *out = after.surfactant.data(), *u = after.along.data(), *crossing = after.crossing.data();
  const double per_step = 2 / step_s;
  sweep_owners(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    each_owned_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Index e = a.template edge<k>(), n = a.template cell<k>();
      const double crosses = flux[e] - coupling[e] * (next[n] - next[c]);
      crossing[e] = crosses;
      u[e] = crosses * per_step * per_length[e] / (gamma[c] + gamma[n]);
    });
  });
  sweep_cells(metric_.topology(), [=](const auto& a) {
    const Index c = a.c;
    double sum = 0;
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      sum += a.template sign<k>() * crossing[a.template edge<k>()];
    });
    out[c] = gamma[c] - sum * per_area[c];
  });
}

Marangoni::Solution Marangoni::solve(const Before& before, double step_s, double tolerance, int most_iterations,
                                     const After& after) {
  assemble(before, step_s);
  const double* area = metric_.area.data();
  const double scale = std::sqrt(dot(area, area, metric_.topology().cells));
  const int iterations = solver_.solve(coupling_, right_, guess_, tolerance * scale, most_iterations);
  commit(before, step_s, after);
  return {iterations >= 0, iterations < 0 ? most_iterations : iterations};
}

}  // namespace shabon::film
