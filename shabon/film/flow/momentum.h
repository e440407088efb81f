// The film's own inertia and viscosity, (75)-(77) in docs/living-film.md; what is stiff (elasticity, drag) is for
// marangoni.h.
#pragma once

#include "shabon/film/flow/metric.h"

namespace shabon::film {

class Momentum {
 public:
  explicit Momentum(const Metric& metric);

  // Advection of the velocity in vector-invariant form, (75), by three Runge-Kutta stages, then shear viscosity, (76),
  // in as many stages as it needs to be stable. `push` is the acceleration by all that is not advection, known from the
  // step before: the stages feel it, the result is without it. `left` becomes the velocity across the edges at half the
  // step.
  void advance(const Numbers& along, const Numbers& push, double step_s, double viscosity_m2_s, Numbers& advanced,
               Numbers& left);

  // Viscous stages for a step, at least one.
  int viscous_stages(double step_s, double viscosity_m2_s) const;

 private:
  void early_stage(const Numbers& base, const Numbers& now, const Numbers& push, double share_s, Numbers& next);
  void last_stage(const Numbers& base, const Numbers& now, double share_s, Numbers& next, Numbers& left);
  void viscous_stage(const Numbers& now, double of_now, const Numbers& before, double of_before, double share_m2,
                     Numbers& next);
  void diffuse(Numbers& along, double step_m2, int stages);

  const Metric& metric_;
  double stiffest_per_m2_ = 0;  // bound of the largest eigenvalue of (76)
  Padded<float> turned_;
  Numbers kinetic_, vorticity_, one_, two_;
};

}  // namespace shabon::film
