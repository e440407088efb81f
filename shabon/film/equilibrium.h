// Thickness model: a film at rest, its weight carried by the surface tension that rises with height, (64). Described in
// a film's own terms: radius, elasticity and density give the squeeze a; `squeeze` sets it at once for a look.
#pragma once

#include <optional>
#include <tuple>

#include "shabon/film/exponential.h"
#include "shabon/film/liquid.h"

namespace shabon::film {

struct EquilibriumThickness {
  double mean_nm = 800;
  double radius_m = 0.03;
  double elasticity_n_m = 22e-3;  // Kim and Mandre 2017
  double density_kg_m3 = 1000;
  std::optional<double> squeeze = {};
};

constexpr About about(Of<EquilibriumThickness>) {
  return {.name = "equilibrium", .doc = "At rest between gravity and surface tension, exponential in height, (64)."};
}

constexpr auto fields(Of<EquilibriumThickness>) {
  constexpr Range squeeze_range{.low = 0, .high = 20};
  return std::tuple{
      Field{"mean_nm",
            &EquilibriumThickness::mean_nm,
            {.unit = "nm", .range = thickness_range_nm, .required = true, .doc = "mean thickness over the sphere"}},
      Field{"radius_m",
            &EquilibriumThickness::radius_m,
            {.unit = "m", .range = bubble_radius_range_m, .doc = "radius of the bubble, for its weight"}},
      Field{"elasticity_n_m",
            &EquilibriumThickness::elasticity_n_m,
            {.unit = "N/m", .range = film_elasticity_range_n_m, .doc = "elasticity of the film, both surfaces"}},
      Field{"density_kg_m3",
            &EquilibriumThickness::density_kg_m3,
            {.unit = "kg/m^3", .range = liquid_density_range_kg_m3, .doc = "density of the liquid"}},
      Field{"squeeze",
            &EquilibriumThickness::squeeze,
            {.range = squeeze_range,
             .unset = "from the three above",
             .doc = "a of (64) in their place: the bottom is exp(2a) times as thick as the top"}}};
}

// a of (64).
double squeeze_of(const EquilibriumThickness& model);

ExponentialThickness prepared(const EquilibriumThickness& model, double seconds);

}  // namespace shabon::film
