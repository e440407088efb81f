// What a shape is made of: THE list of surfaces. docs/adding-a-surface.md adds one.
#pragma once

#include <variant>

#include "shabon/scene/surfaces/conductor.h"
#include "shabon/scene/surfaces/dielectric.h"
#include "shabon/scene/surfaces/diffuse.h"
#include "shabon/scene/surfaces/emitter.h"
#include "shabon/scene/surfaces/free_film.h"
#include "shabon/scene/surfaces/glossy.h"
#include "shabon/scene/surfaces/mix.h"
#include "shabon/scene/surfaces/pane.h"

namespace shabon::scene {

using Surface = std::variant<FreeFilmSurface, DielectricSurface, ConductorSurface, PaneSurface, DiffuseSurface,
                             GlossySurface, EmitterSurface, MixSurface, MaskSurface>;

}  // namespace shabon::scene
