// How thick a film is over its surface: THE list of thickness models. docs/adding-a-thickness-model.md adds one.
#pragma once

#include <variant>

#include "shabon/film/constant.h"
#include "shabon/film/linear.h"

namespace shabon::film {

// Each model is a plain struct in a file of its own with three functions beside it: about() names it, fields() lists
// its parameters, thickness_nm() computes it. Scene keys, their checks, documentation and tests follow from this list.
using ThicknessModel = std::variant<ConstantThickness, LinearThickness>;

// Thickness in nm in the unit direction `from_centre` of a sphere; Number is double or a packet of it.
template <class Number>
Number thickness_nm(const ThicknessModel& model, const math::Vec3<Number>& from_centre) {
  return std::visit([&](const auto& chosen) { return thickness_nm(chosen, from_centre); }, model);
}

}  // namespace shabon::film
