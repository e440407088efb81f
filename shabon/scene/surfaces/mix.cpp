#include "shabon/scene/surfaces/mix.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const MixSurfaceDesc& surface, const Path& path, Problems& problems) {
  check_beside_map(surface.amount != MixSurfaceDesc{}.amount, surface.amount_map.has_value(), "amount", "amount_map",
                   path, problems);
}

void check(const MaskSurfaceDesc& surface, const Path& path, Problems& problems) {
  check_beside_map(surface.opacity != MaskSurfaceDesc{}.opacity, surface.opacity_map.has_value(), "opacity",
                   "opacity_map", path, problems);
}

std::optional<MixSurface> compile(const MixSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  const NumberTexture amount = compiler.number(surface.amount, surface.amount_map, path, "amount_map");
  const Path surfaces{&path, "surfaces"};
  std::vector<std::optional<int>> parts;
  for (const SurfaceDesc& part : surface.surfaces) {
    if (compiler.problems().full()) return {};
    parts.push_back(compiler.add(part, Path{&surfaces, {}, static_cast<int>(parts.size())}));
  }
  if (parts.size() != 2 || !parts[0] || !parts[1]) return {};
  return MixSurface{*parts[0], *parts[1], amount};
}

std::optional<MaskSurface> compile(const MaskSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  const NumberTexture opacity = compiler.number(surface.opacity, surface.opacity_map, path, "opacity_map");
  const std::optional<int> whole = compiler.add(*surface.surface, Path{&path, "surface"});
  if (!whole) return {};
  return MaskSurface{*whole, opacity};
}

}  // namespace shabon::scene
