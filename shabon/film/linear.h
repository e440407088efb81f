// Thickness model: linear in height, (24). Gravity drains a bubble: it is thin at the top and thick at the bottom.
#pragma once

#include <tuple>

#include "shabon/film/range.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct LinearThickness {
  double top_nm = 150;
  double bottom_nm = 900;
};

constexpr About about(Of<LinearThickness>) {
  return {.name = "linear", .doc = "Linear in height over the sphere, as a bubble that drains."};
}

constexpr auto fields(Of<LinearThickness>) {
  constexpr FieldInfo at_top{
      .unit = "nm", .range = thickness_range_nm, .required = true, .doc = "thickness at the highest point (y = +1)"};
  constexpr FieldInfo at_bottom{
      .unit = "nm", .range = thickness_range_nm, .required = true, .doc = "thickness at the lowest point (y = -1)"};
  return std::tuple{Field{"top_nm", &LinearThickness::top_nm, at_top},
                    Field{"bottom_nm", &LinearThickness::bottom_nm, at_bottom}};
}

// Thickness in nm in the unit direction `from_centre` of a sphere.
template <class Number>
Number thickness_nm(const LinearThickness& model, const math::Vec3<Number>& from_centre) {
  const double middle = (model.top_nm + model.bottom_nm) / 2;
  const double slope = (model.top_nm - model.bottom_nm) / 2;
  return Number(middle) + Number(slope) * from_centre.y;
}

}  // namespace shabon::film
