// How a bubble trembles: small oscillations of its shape about the sphere, (89)-(91) in docs/living-film.md.
#pragma once

#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/math/vec.h"

namespace shabon::film {

// What the frequencies depend on.
struct BubbleBody {
  double radius_m = 0.03;
  double thickness_m = 8e-7;    // mean
  double tension_n_m = 25e-3;   // of one surface
  double density_kg_m3 = 1000;  // of the liquid
  double inner_air_kg_m3 = 1.2, outer_air_kg_m3 = 1.2;
};

inline constexpr int highest_degree = 40;

// Angular frequency in rad/s of the modes of degree 2..highest_degree, (89): surface tension against the mass of the
// film and of the air that moves along inside and outside. Other degrees: 0 (a sphere that moves or would change its
// volume). Source: Rayleigh 1879 and Lamb 1932, section 275, with the film's mass added; of no mass it is Grinfeld
// 2012.
double shape_frequency_rad_s(const BubbleBody& body, int degree);

// One mode, zonal about its axis: two lobes for degree 2, three for 3.
struct ShapeMode {
  int degree = 2;
  double amplitude_m = 1e-3;
  math::Vec3d axis{0, 1, 0};
  double phase_deg = 0;
  double quality = 10;  // periods in which the amplitude falls to exp(-pi)
};

constexpr auto fields(Of<ShapeMode>) {
  return std::tuple{
      Field{"degree",
            &ShapeMode::degree,
            {.range = {.low = 2, .high = highest_degree}, .doc = "lobes around the bubble"}},
      Field{"amplitude_m",
            &ShapeMode::amplitude_m,
            {.unit = "m", .range = {.low = 0, .high = 0.05}, .doc = "largest displacement at the axis, at the start"}},
      Field{"axis", &ShapeMode::axis, {.doc = "axis of the lobes, of any length"}},
      Field{"phase_deg",
            &ShapeMode::phase_deg,
            {.unit = "degrees", .range = {.low = -360, .high = 360}, .doc = "of the cosine at the start"}},
      Field{"quality",
            &ShapeMode::quality,
            {.range = {.low = 0.6, .high = 1e6}, .doc = "periods in which the amplitude falls to 4 %"}}};
}

// Displacement at the axis over the radius, (91).
double swing(const BubbleBody& body, const ShapeMode& mode, double time_s);

// Distance from the centre in a unit direction at a time, (90), (91); the volume is kept to the second order in the
// amplitudes.
double radius_m(const BubbleBody& body, const std::vector<ShapeMode>& modes, const math::Vec3d& from_centre,
                double time_s);

// Air's excess pressure inside, 4 tension / radius, in Pa.
double excess_pressure_pa(const BubbleBody& body);

}  // namespace shabon::film
