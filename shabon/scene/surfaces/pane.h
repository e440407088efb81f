// Surface: a thin pane with any stack, thick layers included, and the scene's medium on both sides. Light crosses
// straight: the pane's own thickness is not seen.
#pragma once

#include <optional>
#include <string>
#include <tuple>

#include "shabon/base/field.h"
#include "shabon/optics/stack.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"

namespace shabon::scene {

class SurfaceCompiler;

struct PaneSurface {
  optics::Stack stack;  // coherent and incoherent layers
};

struct PaneSurfaceDesc {
  std::string stack = "air | glass 3mm incoherent | air";
};

constexpr About about(Of<PaneSurfaceDesc>) {
  return {.name = "pane", .doc = "a thin pane, coated or not; light crosses it straight"};
}
constexpr auto fields(Of<PaneSurfaceDesc>) {
  return std::tuple{Field{
      "stack",
      &PaneSurfaceDesc::stack,
      {.required = true,
       .doc =
           "front | coherent and incoherent layers | back, as in \"air | MgF2 99nm | glass 3mm incoherent | air\""}}};
}

std::optional<PaneSurface> compile(const PaneSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
