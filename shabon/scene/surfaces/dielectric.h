// Surface: the boundary of a transparent solid or liquid, smooth or rough (GGX), bare or coated.
#pragma once

#include "shabon/scene/surfaces/coating.h"

namespace shabon::scene {

class SurfaceCompiler;

struct DielectricSurface {
  Coating coating;          // ends in a transparent medium
  NumberTexture roughness;  // GGX alpha; 0 is smooth
};

struct DielectricSurfaceDesc : CoatingDesc, RoughnessDesc {};

constexpr About about(Of<DielectricSurfaceDesc>) {
  return {.name = "dielectric", .doc = "boundary of a transparent solid or liquid"};
}
constexpr auto fields(Of<DielectricSurfaceDesc>) {
  return std::tuple_cat(fields(Of<CoatingDesc>{}), fields(Of<RoughnessDesc>{}));
}

void check(const DielectricSurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<DielectricSurface> compile(const DielectricSurfaceDesc& surface, const Path& path,
                                         SurfaceCompiler& compiler);

}  // namespace shabon::scene
