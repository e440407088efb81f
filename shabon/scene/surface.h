// What a shape is made of: THE list of surfaces. docs/adding-a-surface.md adds one.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>

#include "shabon/base/choice.h"
#include "shabon/scene/surfaces/conductor.h"
#include "shabon/scene/surfaces/dielectric.h"
#include "shabon/scene/surfaces/diffuse.h"
#include "shabon/scene/surfaces/emitter.h"
#include "shabon/scene/surfaces/free_film.h"
#include "shabon/scene/surfaces/glossy.h"
#include "shabon/scene/surfaces/mix.h"
#include "shabon/scene/surfaces/pane.h"

namespace shabon::scene {

// Each surface is two plain structs in a file of surfaces/: the one of the renderer, and what a scene file says of it
// (...Desc) with about() and fields(); compile() makes one from the other.
using Surface = std::variant<FreeFilmSurface, DielectricSurface, ConductorSurface, PaneSurface, DiffuseSurface,
                             GlossySurface, EmitterSurface, MixSurface, MaskSurface>;

// The same list in the same order. A struct, as surfaces hold surfaces.
struct SurfaceDesc {
  std::variant<FreeFilmSurfaceDesc, DielectricSurfaceDesc, ConductorSurfaceDesc, PaneSurfaceDesc, DiffuseSurfaceDesc,
               GlossySurfaceDesc, EmitterSurfaceDesc, MixSurfaceDesc, MaskSurfaceDesc>
      chosen;
};

constexpr std::string_view section(Of<SurfaceDesc>) { return "surface"; }
constexpr auto fields(Of<SurfaceDesc>) { return std::tuple{Choice{&SurfaceDesc::chosen}}; }

// Surfaces and masks that a mix, or a mask, may be made of in all. Each gives light at most two ways to go on, and the
// renderer follows sixteen.
inline constexpr int most_parts = 8;

}  // namespace shabon::scene
