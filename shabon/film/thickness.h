// How thick a film is over its surface: THE list of thickness models. docs/adding-a-thickness-model.md adds one.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>

#include "shabon/base/choice.h"
#include "shabon/film/constant.h"
#include "shabon/film/equilibrium.h"
#include "shabon/film/linear.h"
#include "shabon/film/noise.h"
#include "shabon/film/rigid_drainage.h"
#include "shabon/film/self_similar.h"

namespace shabon::film {

// Each model is a plain struct in a file of its own with three functions beside it: about() names it, fields() lists
// its parameters, thickness_nm() computes it (thickness_field.h). Scene keys, their checks, documentation and tests
// follow from this list.
using ThicknessModel = std::variant<ConstantThickness, LinearThickness, EquilibriumThickness, RigidDrainageThickness,
                                    SelfSimilarThickness, NoiseThickness>;

// A model that another one holds.
struct BaseThickness {
  ThicknessModel model;
};

constexpr std::string_view section(Of<BaseThickness>) { return "thickness below noise"; }
constexpr auto fields(Of<BaseThickness>) { return std::tuple{Choice{&BaseThickness::model}}; }

}  // namespace shabon::film
