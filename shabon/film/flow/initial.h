// The film at the beginning.
#pragma once

#include "shabon/film/flow/film_state.h"
#include "shabon/film/flow/metric.h"

namespace shabon::film {

// Errors: a given thickness that is not positive and finite everywhere.
Result<FilmState> initial_state(const Metric& metric, const FlowDesc& desc, const FilmFlow::InitialThickness& given);

// A state of the right sizes, all zero.
FilmState empty_state(const Metric& metric);

// Gravity over elasticity, a of (79): how much the balance of the two squeezes the film.
double squeeze(const FlowDesc& desc);

// Below this a of (95) some surfactant is left at the top of a film of this slope (InitialFilmDesc).
double most_balanced_squeeze(double slope);

}  // namespace shabon::film
