// One step of the film in time: inertia, elasticity, transport, exchange of liquid; and how long a step may be.
#pragma once

#include "shabon/film/flow/air_field.h"
#include "shabon/film/flow/film_state.h"
#include "shabon/film/flow/marangoni.h"
#include "shabon/film/flow/momentum.h"
#include "shabon/film/flow/transport.h"

namespace shabon::film {

class Stepper {
 public:
  Stepper(const Metric& metric, const FlowDesc& desc);

  // As long a step as may be now, but not beyond `end_s`; several steps of equal length lead there.
  double step_towards(const FilmState& state, double end_s) const;
  // Replaces the state by the one `step_s` later, at `end_s`. Steps that turn out too long are made shorter, so the
  // time afterwards may be earlier. Errors: it would be shorter than the shortest, or the solver does not converge in
  // shorter steps either; the state is then as before.
  Status step(FilmState& state, double step_s, double end_s);

  const Metric& metric() const { return metric_; }

 private:
  enum class Outcome { done, too_fast, not_converged };
  struct Trial {
    Outcome outcome = Outcome::done;
    double courant = 0;
    int iterations = 0;
  };
  Trial attempt(const FilmState& state, double step_s);
  double crossing_rate(const Numbers& along) const;  // cells per second, the most at any edge
  void finish(FilmState& state, double step_s, double end_s, const Trial& trial);
  Diagnostics cannot_go_on(const FilmState& state, double step_s, const Trial& trial) const;

  const Metric& metric_;
  const FlowDesc& desc_;
  double viscosity_m2_s_, longest_s_;
  AirField air_;
  Momentum momentum_;
  Marangoni marangoni_;
  Transport transport_;
  Numbers inertial_, left_, along_, crossing_, surfactant_, thickness_;  // of the step that is tried
};

// Kinematic viscosity of the film in its plane, (77).
double film_viscosity_m2_s(const FlowDesc& desc);

}  // namespace shabon::film
