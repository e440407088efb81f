// A film whose state a test may set: description, stepper and state side by side.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shabon/film/flow/initial.h"
#include "shabon/film/flow/stepper.h"

#ifndef SHABON_FLOW_LEVEL
#define SHABON_FLOW_LEVEL 4
#endif

namespace shabon::film::test {

inline constexpr int level = SHABON_FLOW_LEVEL;

struct Laboratory {
  FlowDesc desc;
  Metric metric;
  Stepper stepper;
  FilmState film;

  explicit Laboratory(const FlowDesc& chosen)
      : desc(chosen),
        metric(sphere_grid(desc.level), desc.radius_m),
        stepper(metric, desc),
        film(std::move(*initial_state(metric, desc, {}))) {}

  void run_to(double end_s) {
    while (film.time_s < end_s) {
      const double step_s = stepper.step_towards(film, end_s);
      const bool last = step_s >= end_s - film.time_s;
      const Status done = stepper.step(film, step_s, last ? end_s : film.time_s + step_s);
      ASSERT_TRUE(done.ok()) << to_text(done.errors());
    }
  }

  // Velocities of a stream function given at the corners' directions, in m^2/s.
  template <class Stream>
  void set_stream(const Stream& stream) {
    Numbers values = metric.grid->triangle_numbers();
    for (std::size_t t = 0; t < values.size(); ++t) values[t] = stream(metric.grid->corners[t]);
    from_stream(metric, values, film.along);
  }

  template <class Function>
  double project(const Numbers& cells, const Function& function) const {
    double sum = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) sum += metric.area[c] * cells[c] * function(metric.grid->centres[c]);
    return sum;
  }
  // Of edges: both fields, weighted by what they stand for.
  double overlap(const Numbers& a, const Numbers& b) const {
    double sum = 0;
    for (std::size_t e = 0; e < a.size(); ++e) sum += metric.length[e] * metric.distance[e] * a[e] * b[e];
    return sum;
  }
};

// A quiet film of 5 cm radius and 1 um: no noise, no gravity, no drag, no viscosity.
inline FlowDesc quiet_film() {
  FlowDesc desc;
  desc.level = level;
  desc.radius_m = 0.05;
  desc.mean_thickness_nm = 1000;
  desc.viscosity_pa_s = desc.surface_viscosity_kg_s = 0;
  desc.air_drag_kg_m2_s = 0;
  desc.gravity_m_s2 = {0, 0, 0};
  desc.initial.noise = 0;
  return desc;
}

// Legendre polynomials.
inline double legendre(int l, double x) {
  double before = 1, now = x;
  if (l == 0) return 1;
  for (int n = 1; n < l; ++n) {
    const double next = ((2 * n + 1) * x * now - n * before) / (n + 1);
    before = now, now = next;
  }
  return now;
}

}  // namespace shabon::film::test
