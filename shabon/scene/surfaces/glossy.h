// Surface: a diffuse base under a transparent boundary, smooth or rough (GGX), bare or coated: lacquer, plastic, wet
// asphalt.
#pragma once

#include "shabon/scene/surfaces/coating.h"
#include "shabon/scene/surfaces/diffuse.h"

namespace shabon::scene {

struct GlossySurface {
  Coating coating;  // ends in the transparent medium that the base is embedded in
  NumberTexture roughness;
  ReflectanceTexture base;
};

struct GlossySurfaceDesc : CoatingDesc, RoughnessDesc, BaseColorDesc {};

constexpr About about(Of<GlossySurfaceDesc>) {
  return {.name = "glossy", .doc = "a diffuse base in a transparent medium: lacquer, plastic, wet asphalt"};
}
constexpr auto fields(Of<GlossySurfaceDesc>) {
  return std::tuple_cat(fields(Of<CoatingDesc>{}), fields(Of<RoughnessDesc>{}), fields(Of<BaseColorDesc>{}));
}

void check(const GlossySurfaceDesc& surface, const Path& path, Problems& problems);
std::optional<GlossySurface> compile(const GlossySurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
