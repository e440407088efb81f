// Thickness model: a mobile film that drains, (67). That time and height separate, h(z, t) = f(t) G(z), was found by
// Monier et al. 2024 (Self-similar and universal dynamics in drainage of mobile soap films, arXiv:2401.03931) for
// upright rectangular films. The two functions are chosen here: G as the equilibrium has it, since a mobile film is in
// balance with gravity at every moment; f a power of time, as if the film were exchanged the slower the thinner it is.
#pragma once

#include <tuple>

#include "shabon/film/exponential.h"
#include "shabon/film/liquid.h"

namespace shabon::film {

struct SelfSimilarThickness {
  double top_nm = 300;
  double bottom_nm = 1500;
  double half_time_s = 10;
  double exponent = 1;
  double age_s = 0;
};

constexpr About about(Of<SelfSimilarThickness>) {
  return {.name = "self_similar", .doc = "A mobile film that thins everywhere in the same measure, (67)."};
}

constexpr auto fields(Of<SelfSimilarThickness>) {
  constexpr Range some_nm{.low = 1e-3, .high = thickness_range_nm.high};
  return std::tuple{
      Field{"top_nm",
            &SelfSimilarThickness::top_nm,
            {.unit = "nm", .range = some_nm, .required = true, .doc = "thickness at the highest point at age 0"}},
      Field{"bottom_nm",
            &SelfSimilarThickness::bottom_nm,
            {.unit = "nm", .range = some_nm, .required = true, .doc = "thickness at the lowest point at age 0"}},
      Field{"half_time_s",
            &SelfSimilarThickness::half_time_s,
            {.unit = "s", .range = {.low = 1e-6, .high = 1e9}, .doc = "age at which half of the thickness is left"}},
      Field{"exponent",
            &SelfSimilarThickness::exponent,
            {.range = {.low = 0.1, .high = 10}, .doc = "power of time by which an old film thins"}},
      Field{"age_s",
            &SelfSimilarThickness::age_s,
            {.unit = "s", .range = film_age_range_s, .doc = "age at the scene's time 0"}}};
}

ExponentialThickness prepared(const SelfSimilarThickness& model, double seconds);

}  // namespace shabon::film
