#include "shabon/scene/surfaces/emitter.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

void check(const EmitterSurfaceDesc& surface, const Path& path, Problems& problems) {
  check(static_cast<const LampDesc&>(surface), path, problems);
  if (surface.scale == 0) problems.add_warning(Path{&path, "scale"}, "a lamp of scale 0 gives no light");
}

std::optional<EmitterSurface> compile(const EmitterSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler) {
  return EmitterSurface{compiler.lamp(surface, path), surface.scale, surface.both_sides};
}

}  // namespace shabon::scene
