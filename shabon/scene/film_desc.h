// A film as a scene file states it: what it is made of, and how thick it is.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "shabon/film/thickness.h"
#include "shabon/scene/flow_desc.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/ranges.h"
#include "shabon/scene/texture_desc.h"

namespace shabon::scene {

template <class Variant, class... More>
struct Extended;
template <class... T, class... More>
struct Extended<std::variant<T...>, More...> {
  using type = std::variant<T..., More...>;
};

// The thickness models, a picture, or a simulated film.
using ThicknessDesc = Extended<film::ThicknessModel, ThicknessMapDesc, FlowThicknessDesc>::type;

constexpr std::string_view section(Of<ThicknessDesc>) { return "thickness"; }

// The model, or nothing for the others.
inline std::optional<film::ThicknessModel> thickness_model(const ThicknessDesc& thickness) {
  return std::visit(
      [](const auto& chosen) -> std::optional<film::ThicknessModel> {
        if constexpr (std::is_constructible_v<film::ThicknessModel, decltype(chosen)>) return chosen;
        return {};
      },
      thickness);
}

inline ThicknessDesc thickness_desc(const film::ThicknessModel& model) {
  return std::visit([](const auto& chosen) { return ThicknessDesc(chosen); }, model);
}

// A film of one medium between air on both sides.
struct MediumFilmDesc {
  std::string medium = "water";  // a name, a number such as 1.33 or 1.33+0.01i, or file:PATH
  ThicknessDesc thickness;
};

// The layer of a stack whose thickness differs from place to place, in place of the one written in the stack.
struct VariedLayerDesc {
  int layer = 1;  // the outermost is 1
  ThicknessDesc thickness;
};

// A stack expression, from the outside to the inside.
struct StackFilmDesc {
  std::string stack = "air | water 400nm | air";
  std::optional<VariedLayerDesc> vary = {};
};

using FilmDesc = std::variant<MediumFilmDesc, StackFilmDesc>;

constexpr About about(Of<MediumFilmDesc>) { return {.name = "medium", .doc = "one medium", .flat = true}; }
constexpr auto fields(Of<MediumFilmDesc>) {
  return std::tuple{
      Field{"medium",
            &MediumFilmDesc::medium,
            {.required = true, .doc = "name of a medium, index such as 1.33 or 1.33+0.01i, or file:PATH"}},
      Field{"thickness", &MediumFilmDesc::thickness, {.required = true, .doc = "how thick the film is, and where"}}};
}

constexpr auto fields(Of<VariedLayerDesc>) {
  return std::tuple{
      Field{"layer", &VariedLayerDesc::layer, {.range = layer_range, .doc = "its number, from 1 at the outside"}},
      Field{"thickness",
            &VariedLayerDesc::thickness,
            {.required = true, .doc = "its thickness, in place of the one written in the stack"}}};
}

constexpr About about(Of<StackFilmDesc>) { return {.name = "stack", .doc = "a stack expression", .flat = true}; }
constexpr auto fields(Of<StackFilmDesc>) {
  return std::tuple{
      Field{"stack",
            &StackFilmDesc::stack,
            {.required = true, .doc = "instead: outside | layers | inside, as in \"air | water 300nm | air\""}},
      Field{"vary", &StackFilmDesc::vary, {.doc = "with a stack: one of its layers and how thick it is, and where"}}};
}

void check(const MediumFilmDesc& film, const Path& path, Problems& problems);
void check(const StackFilmDesc& film, const Path& path, Problems& problems);

}  // namespace shabon::scene
