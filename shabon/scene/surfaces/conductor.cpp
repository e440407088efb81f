#include "shabon/scene/surfaces/conductor.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const ConductorSurfaceDesc& surface, const Path& path, Problems& problems) {
  check_roughness(surface, path, problems);
}

std::optional<ConductorSurface> compile(const ConductorSurfaceDesc& surface, const Path& path,
                                        SurfaceCompiler& compiler) {
  const NumberTexture roughness = compiler.number(surface.roughness, surface.roughness_map, path, "roughness_map");
  const std::optional<Coating> coating = compiler.coating(surface, path);
  if (!coating) return {};
  const optics::Medium& back = coating->stack.exit;
  if (is_transparent(back))
    compiler.problems().add(Path{&path, "stack"}, "expected an absorbing medium at the back, got '" + back.name() +
                                                      "', which is transparent; the surface 'dielectric' takes it");
  return ConductorSurface{*coating, roughness};
}

}  // namespace shabon::scene
