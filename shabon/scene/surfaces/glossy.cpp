#include "shabon/scene/surfaces/glossy.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const GlossySurfaceDesc& surface, const Path& path, Problems& problems) {
  check_roughness(surface, path, problems);
  check_color(surface, path, problems);
}

std::optional<GlossySurface> compile(const GlossySurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  const NumberTexture roughness = compiler.number(surface.roughness, surface.roughness_map, path, "roughness_map");
  const ReflectanceTexture base = compiler.color(surface, path);
  const std::optional<Coating> coating = compiler.coating(surface, path);
  if (!coating) return {};
  const optics::Medium& around = coating->stack.exit;
  if (!is_transparent(around))
    compiler.problems().add(Path{&path, "stack"}, "expected a transparent medium around the base, got '" +
                                                      around.name() + "', which absorbs");
  return GlossySurface{*coating, roughness, base};
}

}  // namespace shabon::scene
