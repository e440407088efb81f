#include "shabon/scene/surfaces/diffuse.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const DiffuseSurfaceDesc& surface, const Path& path, Problems& problems) {
  check_color(surface, path, problems);
}

std::optional<DiffuseSurface> compile(const DiffuseSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  return DiffuseSurface{compiler.color(surface, path)};
}

}  // namespace shabon::scene
