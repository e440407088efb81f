#include "shabon/film/flow/stepper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shabon/base/random.h"
#include "shabon/base/text.h"
#include "shabon/film/flow/exchange.h"

namespace shabon::film {

namespace {

// How far steps aim below the most that they may cross: a film that gets a little faster within one is not taken back.
constexpr double courant_reserve = 1.2;
// The longest step in units of R^2/viscosity: shear (76) is a stage of its own, and where it dies away faster than a step
// lasts, what drives it comes out too strong; above about 4 the push of (75) and the shear even swing up.
constexpr double viscous_reach = 0.05;
constexpr double rash = 0.5;  // factor for a step that failed
// So often a step is made shorter for a solver that does not converge. Each time the matrix is four times closer to
// that of the areas; what still does not converge then fails for another reason.
constexpr int most_unsolved = 4;

FilmForces forces_of(const FlowDesc& desc) {
  return {desc.density_kg_m3, desc.elasticity_n_m, desc.air_drag_kg_m2_s, film_viscosity_m2_s(desc)};
}

bool all_positive(const Numbers& cells) {
  const double* value = cells.data();
  const auto count = static_cast<Index>(cells.size());
  long bad = 0;
  for (Index c = 0; c < count; ++c) bad += value[c] > 0 && value[c] < 1e300 ? 0 : 1;
  return bad == 0;
}

}  // namespace

double film_viscosity_m2_s(const FlowDesc& desc) {
  return (desc.viscosity_pa_s + 2 * desc.surface_viscosity_kg_s / (desc.mean_thickness_nm * 1e-9)) / desc.density_kg_m3;
}

Stepper::Stepper(const Metric& metric, const FlowDesc& desc)
    : metric_(metric),
      desc_(desc),
      viscosity_m2_s_(film_viscosity_m2_s(desc)),
      longest_s_(std::min(desc.step.longest_s, viscous_reach * desc.radius_m * desc.radius_m / viscosity_m2_s_)),
      air_(metric, desc.air, hash64(desc.seed, 5)),
      momentum_(metric),
      marangoni_(metric, forces_of(desc), desc.gravity_m_s2),
      transport_(metric),
      inertial_(metric.grid->edge_numbers()),
      left_(inertial_),
      along_(inertial_),
      crossing_(inertial_),
      surfactant_(metric.grid->cell_numbers(1)),
      thickness_(surfactant_) {}

double Stepper::crossing_rate(const Numbers& along) const {
  constexpr Index block = 8;
  std::array<double, block> most{};
  const double *u = along.data(), *per_distance = metric_.per_distance.data();
  const auto count = static_cast<Index>(along.size()) / block * block;
  const auto larger = [](double a, double b) { return b <= a ? a : b; };  // a number that is none wins
  for (Index e = 0; e < count; e += block)
    for (Index j = 0; j < block; ++j) {
      double& here = most[static_cast<std::size_t>(j)];
      here = larger(here, std::abs(u[e + j]) * per_distance[e + j]);
    }
  double all = 0;
  for (Index e = count; e < static_cast<Index>(along.size()); ++e) all = larger(all, std::abs(u[e]) * per_distance[e]);
  for (const double one : most) all = larger(all, one);
  return all;
}

double Stepper::step_towards(const FilmState& state, double end_s) const {
  const double left_s = end_s - state.time_s, rate = crossing_rate(state.along);
  const double may_s = std::min(longest_s_, desc_.step.courant / courant_reserve / std::max(rate, 1e-9));
  return left_s / std::max(1.0, std::ceil(left_s / may_s * (1 - 1e-9)));
}

Stepper::Trial Stepper::attempt(const FilmState& state, double step_s) {
  const Numbers& wind = air_.at(state.time_s + step_s);
  momentum_.advance(state.along, state.push, step_s, viscosity_m2_s_, inertial_, left_);
  const auto solution =
      marangoni_.solve({state.thickness, state.surfactant, state.surfactant_last, inertial_, wind}, step_s,
                       desc_.step.tolerance, desc_.step.most_iterations, {surfactant_, along_, crossing_});
  Trial trial{Outcome::done, crossing_rate(along_) * step_s, solution.iterations};
  if (!solution.converged) trial.outcome = Outcome::not_converged;
  if (!(trial.courant <= desc_.step.courant)) trial.outcome = Outcome::too_fast;
  if (trial.outcome != Outcome::done) return trial;
  transport_.move({crossing_, along_, left_, step_s}, state.surfactant, surfactant_, state.thickness, thickness_);
  if (!all_positive(surfactant_) || !all_positive(thickness_)) trial.outcome = Outcome::too_fast;
  return trial;
}

void Stepper::finish(FilmState& state, double step_s, double end_s, const Trial& trial) {
  std::swap(state.surfactant_last, state.surfactant);
  std::swap(state.surfactant, surfactant_);
  std::swap(state.thickness, thickness_);
  std::swap(state.along, along_);
  const double *u = state.along.data(), *before = inertial_.data(), per_step = 1 / step_s;
  double* push = state.push.data();
  for (Index e = 0; e < metric_.topology().edges; ++e) push[e] = (u[e] - before[e]) * per_step;
  state.time_s = end_s;
  if (desc_.evaporation) evaporate(metric_, desc_, step_s, state);
  if (desc_.regeneration) regenerate(metric_, desc_, end_s, state);
  if (desc_.black_film) collapse(metric_, desc_, end_s, step_s, state);
  if (desc_.rupture) break_if_thin(metric_, desc_, end_s, state);
  FlowReport& frame = state.frame;
  frame.courant = std::max(frame.courant, trial.courant);
  frame.shortest_step_s = frame.steps == 0 ? step_s : std::min(frame.shortest_step_s, step_s);
  frame.longest_step_s = std::max(frame.longest_step_s, step_s);
  frame.iterations += trial.iterations;
  ++frame.steps;
}

Diagnostics Stepper::cannot_go_on(const FilmState& state, double step_s, const Trial& trial) const {
  const std::string when = "the film stopped at " + format_number(state.time_s, 6) + " s: ";
  if (trial.outcome == Outcome::not_converged)
    return fail(Failure::content, when + "its elastic step did not converge in " +
                                      std::to_string(desc_.step.most_iterations) + " iterations, nor in steps of " +
                                      format_number(step_s, 3) +
                                      " s; give more step.most_iterations, a larger step.tolerance or a smaller "
                                      "step.longest_s");
  return fail(Failure::content,
              when + "a step would be " + format_number(step_s, 3) +
                  " s, below step.shortest_s; slow down what drives it (air, gravity_m_s2, initial.swirl_m_s), raise "
                  "elasticity_n_m or viscosity_pa_s, or take a lower level");
}

Status Stepper::step(FilmState& state, double step_s, double end_s) {
  for (int unsolved = 0;;) {
    const Trial trial = attempt(state, step_s);
    if (trial.outcome == Outcome::done) {
      finish(state, step_s, end_s, trial);
      return Done{};
    }
    ++state.frame.repeated;
    if (trial.outcome == Outcome::not_converged && ++unsolved > most_unsolved)
      return cannot_go_on(state, step_s, trial);
    step_s *= rash;
    end_s = state.time_s + step_s;
    if (!(step_s >= desc_.step.shortest_s)) return cannot_go_on(state, step_s, trial);
  }
}

}  // namespace shabon::film
