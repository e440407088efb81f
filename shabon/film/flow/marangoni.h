// The stiff part of a step, implicit: elasticity, gravity, drag of the air and dilatational viscosity, (78) and (79) in
// docs/living-film.md. There is no limit of stability in it.
#pragma once

#include "shabon/film/flow/elastic_solver.h"
#include "shabon/film/flow/metric.h"

namespace shabon::film {

struct FilmForces {
  double density_kg_m3 = 1000;
  double elasticity_n_m = 22e-3;
  double drag_kg_m2_s = 0;
  double viscosity_m2_s = 0;
};

class Marangoni {
 public:
  Marangoni(const Metric& metric, const FilmForces& forces, const math::Vec3d& gravity_m_s2);

  // The film before the elastic step: thickness, surfactant now and one step ago (the guess goes on in a straight
  // line), velocity after inertia, velocity of the air (along the edges).
  struct Before {
    const Numbers& thickness;
    const Numbers& surfactant;
    const Numbers& surfactant_last;
    const Numbers& along;
    const Numbers& air;
  };
  struct After {
    Numbers& surfactant;
    Numbers& along;
    Numbers& crossing;  // surfactant that crosses the edges, m^2
  };
  struct Solution {
    bool converged = false;
    int iterations = 0;
  };
  // The surfactant moves by what crosses the edges, so that its sum is kept whatever `tolerance` is: the residual's
  // root mean square over that of the areas.
  Solution solve(const Before& before, double step_s, double tolerance, int most_iterations, const After& after);

 private:
  void assemble(const Before& before, double step_s);
  void commit(const Before& before, double step_s, const After& after);

  const Metric& metric_;
  FilmForces forces_;
  Numbers gravity_;          // along the edges, m/s^2
  Numbers free_, coupling_;  // of edges
  Numbers guess_, right_;
  ElasticSolver solver_;
};

}  // namespace shabon::film
