// Surface: free films, one or several on the same spot, with the scene's medium on both sides. Light crosses straight.
#pragma once

namespace shabon::scene {

struct FreeFilmSurface {
  int first_film = 0, film_count = 1;  // Scene::films, from the front to the back
};

}  // namespace shabon::scene
