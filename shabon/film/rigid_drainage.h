// Thickness model: a film between two surfaces that do not move (a rigid one, after Mysels), from which the liquid
// drains by its own weight, (65), (66). Slow: hours for a bubble of water, the right thing for thick or viscous films.
#pragma once

#include <memory>
#include <tuple>
#include <vector>

#include "shabon/film/liquid.h"
#include "shabon/film/number.h"
#include "shabon/film/range.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct RigidDrainageThickness {
  double start_nm = 5000;
  double age_s = 0;
  double radius_m = 0.03;
  double viscosity_pa_s = 1e-3;
  double density_kg_m3 = 1000;
  bool plane = false;
};

constexpr About about(Of<RigidDrainageThickness>) {
  return {.name = "rigid_drainage", .doc = "Drained by its weight between rigid surfaces, uniform at age 0, (65)."};
}

constexpr auto fields(Of<RigidDrainageThickness>) {
  using Model = RigidDrainageThickness;
  return std::tuple{
      Field{"start_nm",
            &Model::start_nm,
            {.unit = "nm", .range = thickness_range_nm, .required = true, .doc = "thickness at age 0, everywhere"}},
      Field{"age_s", &Model::age_s, {.unit = "s", .range = film_age_range_s, .doc = "age at the scene's time 0"}},
      Field{"radius_m",
            &Model::radius_m,
            {.unit = "m",
             .range = bubble_radius_range_m,
             .doc = "radius of the bubble; half the height of a plane film"}},
      Field{"viscosity_pa_s",
            &Model::viscosity_pa_s,
            {.unit = "Pa s", .range = liquid_viscosity_range_pa_s, .doc = "viscosity of the liquid"}},
      Field{"density_kg_m3",
            &Model::density_kg_m3,
            {.unit = "kg/m^3", .range = liquid_density_range_kg_m3, .doc = "density of the liquid"}},
      Field{"plane", &Model::plane, {.doc = "a plane film upright in a frame, (66), instead of a bubble"}}};
}

// The time tau of (65), after which the top of a bubble has lost 1 - 1/sqrt(2) of its thickness.
double drainage_time_s(const RigidDrainageThickness& model);

// The drop at the bottom takes what would make the film thicker than so many times its start.
inline constexpr double drop_ratio = 10;

// The thickness over the start at the polar angle `polar` from the top, 0..pi, and the age `time`, in units of tau. By
// characteristics, (65), to about 1e-12; not bounded by the drop: infinite at the bottom from time 1 on.
double drained_share(double polar, double time);

struct DrainedThickness {
  double start_nm = 0;
  // Of a bubble: at equal steps of sqrt((1 + y)/2), from the bottom to the top; linear between them.
  std::shared_ptr<const std::vector<double>> nm;
  double nm_at_half_height = 0;  // of a plane film, if it were not bounded by its start; 0 for a bubble
};

DrainedThickness prepared(const RigidDrainageThickness& model, double seconds);

// Thickness in nm in the unit direction `from_centre` of a sphere.
template <class Number>
Number thickness_nm(const DrainedThickness& film, const math::Vec3<Number>& from_centre) {
  using std::floor, std::max, std::min, std::sqrt;
  const Number zero(0.0), one(1.0);
  if (film.nm == nullptr)  // (66)
    return min(Number(film.start_nm), Number(film.nm_at_half_height) * sqrt(max(one - from_centre.y, zero)));
  const Number last(static_cast<double>(film.nm->size()) - 2);
  const Number height = max(zero, min(one, Number(0.5) + Number(0.5) * from_centre.y));
  const Number at = sqrt(height) * (last + one);
  const Number below = min(floor(at), last);
  constexpr int lanes = lane_count_of<Number>();
  alignas(64) double index[lanes], nodes[2][lanes];
  to_lanes(below, index);
  for (int i = 0; i < lanes; ++i) {
    const double* node = film.nm->data() + static_cast<std::ptrdiff_t>(index[i]);
    nodes[0][i] = node[0], nodes[1][i] = node[1];
  }
  const Number a = from_lanes<Number>(nodes[0]);
  return a + (at - below) * (from_lanes<Number>(nodes[1]) - a);
}

}  // namespace shabon::film
