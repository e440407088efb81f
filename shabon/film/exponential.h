// A thickness that grows downwards by the same factor over each step of height.
#pragma once

#include <algorithm>
#include <cmath>

#include "shabon/film/range.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct ExponentialThickness {
  double middle_nm = 400;  // at half height
  double doublings = 0;    // from there to the bottom
};

// Thickness in nm in the unit direction `from_centre` of a sphere; no more than a film may have.
template <class Number>
Number thickness_nm(const ExponentialThickness& film, const math::Vec3<Number>& from_centre) {
  using std::exp2, std::min;
  return min(Number(film.middle_nm) * exp2(Number(-film.doublings) * from_centre.y), Number(thickness_range_nm.high));
}

}  // namespace shabon::film
