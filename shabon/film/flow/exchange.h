// Liquid that leaves the film or moves within it besides the flow, (85)-(88) in docs/living-film.md. Each changes the
// thickness of the state and puts what left into its ledger.
#pragma once

#include "shabon/film/flow/film_state.h"
#include "shabon/film/flow/metric.h"

namespace shabon::film {

// No source makes the film thinner than this; a Newton black film is not much thicker.
inline constexpr double thinnest_film_m = 4e-9;

void evaporate(const Metric& metric, const FlowDesc& desc, double step_s, FilmState& state);
// The patches whose time lies within the step that ends at `end_s`.
void regenerate(const Metric& metric, const FlowDesc& desc, double end_s, FilmState& state);
// Seeds and grows black film. Keeps the liquid: what leaves a cell is in its neighbours.
void collapse(const Metric& metric, const FlowDesc& desc, double end_s, double step_s, FilmState& state);
// Breaks the film where it is thinner than the seeded threshold.
void break_if_thin(const Metric& metric, const FlowDesc& desc, double end_s, FilmState& state);

// What counts as black film.
inline bool is_black(const BlackFilmDesc& black, double thickness_m) {
  return thickness_m <= 1.25e-9 * black.thickness_nm;
}

}  // namespace shabon::film
