// How a bubble bursts: a hole whose rim gathers the film and runs at a constant speed, (92)-(94) in
// docs/living-film.md.
#pragma once

#include <tuple>

#include "shabon/base/field.h"
#include "shabon/film/shape_modes.h"
#include "shabon/math/vec.h"

namespace shabon::film {

// Speed of the rim in m/s, (92): tension pulls at what it has gathered (Taylor 1959, Culick 1960).
double taylor_culick_m_s(double tension_n_m, double density_kg_m3, double thickness_m);

struct PoppingDesc {
  math::Vec3d from_centre{0, 1, 0};
  double start_s = 0;
  double slow_motion = 1;
};

constexpr auto fields(Of<PoppingDesc>) {
  return std::tuple{
      Field{"from_centre", &PoppingDesc::from_centre, {.doc = "where the hole opens: a direction of any length"}},
      Field{"start_s", &PoppingDesc::start_s, {.unit = "s", .range = {.low = 0, .high = 1e6}, .doc = "when it opens"}},
      Field{"slow_motion",
            &PoppingDesc::slow_motion,
            {.range = {.low = 1, .high = 1e6}, .doc = "how many times slower than in nature"}}};
}

struct Hole {
  double angle_rad = 0;      // from the hole's middle to its rim, seen from the centre: 0 whole, pi gone
  double rim_radius_m = 0;   // of the rim's round section
  double rim_volume_m3 = 0;  // liquid that the film had where the hole is
};

// The hole at a time, (93), (94), for film of one thickness. A rim that would be thicker than what is left of the
// bubble's opening counts as gone.
Hole hole_at(const BubbleBody& body, const PoppingDesc& popping, double time_s);

// From the first hole to nothing, in s.
double popping_duration_s(const BubbleBody& body, const PoppingDesc& popping);

}  // namespace shabon::film
