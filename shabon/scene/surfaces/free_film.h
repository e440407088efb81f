// Surface: free films, one or several on the same spot, with the scene's medium on both sides. Light crosses straight.
#pragma once

#include <optional>
#include <tuple>

#include "shabon/base/choice.h"
#include "shabon/scene/film_desc.h"

namespace shabon::scene {

class SurfaceCompiler;

struct FreeFilmSurface {
  int first_film = 0, film_count = 1;  // Scene::films, from the front to the back
};

struct FreeFilmSurfaceDesc {
  FilmDesc film;
};

constexpr About about(Of<FreeFilmSurfaceDesc>) {
  return {.name = "film", .doc = "a film that stands free, as that of a bubble"};
}
constexpr auto fields(Of<FreeFilmSurfaceDesc>) { return std::tuple{Choice{&FreeFilmSurfaceDesc::film}}; }

std::optional<FreeFilmSurface> compile(const FreeFilmSurfaceDesc& surface, const Path& path, SurfaceCompiler& compiler);

}  // namespace shabon::scene
