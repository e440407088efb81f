#include "shabon/scene/surfaces/free_film.h"

#include "shabon/scene/compile_surfaces.h"

namespace shabon::scene {

std::optional<FreeFilmSurface> compile(const FreeFilmSurfaceDesc& surface, const Path& path,
                                       SurfaceCompiler& compiler) {
  const std::optional<Film> film = compiler.film(surface.film, path);
  if (!film) return {};
  if (film->flow) {
    compiler.problems().add(Path{&path, "thickness"}, simulated_elsewhere);
    return {};
  }
  return FreeFilmSurface{compiler.add_film(*film), 1};
}

}  // namespace shabon::scene
