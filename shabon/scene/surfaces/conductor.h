// Surface: a metal or any other medium that lets no light through, smooth or rough (GGX), bare or coated.
#pragma once

#include "shabon/scene/surfaces/coating.h"

namespace shabon::scene {

class SurfaceCompiler;

struct ConductorSurface {
  Coating coating;          // ends in an absorbing medium
  NumberTexture roughness;  // GGX alpha; 0 is smooth
};

struct ConductorSurfaceDesc : CoatingDesc, RoughnessDesc {
  ConductorSurfaceDesc() : CoatingDesc{"air | Ti"} {}
};

constexpr About about(Of<ConductorSurfaceDesc>) {
  return {.name = "conductor", .doc = "a metal or another medium that lets no light through"};
}
constexpr auto fields(Of<ConductorSurfaceDesc>) {
  return std::tuple_cat(fields(Of<CoatingDesc>{}), fields(Of<RoughnessDesc>{}));
}

void check(const ConductorSurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<ConductorSurface> compile(const ConductorSurfaceDesc& surface, const Path& path,
                                        SurfaceCompiler& compiler);

}  // namespace shabon::scene
