#include "shabon/scene/surfaces/dielectric.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const DielectricSurfaceDesc& surface, const Path& path, Problems& problems) {
  check_roughness(surface, path, problems);
}

std::optional<DielectricSurface> compile(const DielectricSurfaceDesc& surface, const Path& path,
                                         SurfaceCompiler& compiler) {
  const NumberTexture roughness = compiler.number(surface.roughness, surface.roughness_map, path, "roughness_map");
  const std::optional<Coating> coating = compiler.coating(surface, path);
  if (!coating) return {};
  const optics::Medium& back = coating->stack.exit;
  compiler.media().behind(back);
  if (!is_transparent(back))
    compiler.problems().add(Path{&path, "stack"}, "expected a transparent medium at the back, got '" + back.name() +
                                                      "', which absorbs; the surface 'conductor' takes it");
  return DielectricSurface{*coating, roughness};
}

}  // namespace shabon::scene
