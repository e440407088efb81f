// How thick a film is over its surface: THE list of thickness models. docs/adding-a-thickness-model.md adds one.
#pragma once

#include <variant>

#include "shabon/film/constant.h"
#include "shabon/film/linear.h"

namespace shabon::film {

// Each model is a plain struct in a file of its own with three functions beside it: about() names it, fields() lists
// its parameters, thickness_nm() computes it (thickness_field.h). Scene keys, their checks, documentation and tests
// follow from this list.
using ThicknessModel = std::variant<ConstantThickness, LinearThickness>;

}  // namespace shabon::film
