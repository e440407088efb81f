// Thickness model: the same everywhere.
#pragma once

#include <tuple>

#include "shabon/film/range.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct ConstantThickness {
  double constant_nm = 400;
};

constexpr About about(Of<ConstantThickness>) {
  return {.name = "constant", .doc = "The same thickness everywhere.", .flat = true};
}

constexpr auto fields(Of<ConstantThickness>) {
  return std::tuple{
      Field{"constant_nm",
            &ConstantThickness::constant_nm,
            {.unit = "nm", .range = thickness_range_nm, .required = true, .doc = "thickness of the film"}}};
}

// Thickness in nm in the unit direction `from_centre` of a sphere.
template <class Number>
Number thickness_nm(const ConstantThickness& model, const math::Vec3<Number>& /*from_centre*/) {
  return Number(model.constant_nm);
}

}  // namespace shabon::film
