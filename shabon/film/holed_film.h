// A film with a round hole: what is left of one that bursts. No film is as good as one of no thickness: light passes.
#pragma once

#include "shabon/base/indirect.h"
#include "shabon/film/number.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct HeldField;  // a ThicknessField: thickness_field.h

struct HoledFilm {
  Indirect<HeldField> film;
  math::Vec3d axis{0, 1, 0};  // unit, from the centre to the hole's middle
  double cos_hole = 1;        // of the angle from there to the hole's rim: 1 whole, -1 gone
};

namespace detail {

// `nm` outside of the hole, 0 in it. The direction may have any length.
template <class Number>
Number outside_hole(const HoledFilm& holed, const math::Vec3<Number>& from_centre, const Number& nm) {
  using std::sqrt;
  const auto& [x, y, z] = holed.axis;
  const Number along = from_centre.x * Number(x) + from_centre.y * Number(y) + from_centre.z * Number(z);
  return select(along > Number(holed.cos_hole) * sqrt(dot(from_centre, from_centre)), Number(0.0), nm);
}

}  // namespace detail

}  // namespace shabon::film
