// Whether the simulated films of a scene have run before it is looked at.
#pragma once

#include "shabon/base/result.h"
#include "shabon/scene/scene.h"

namespace shabon::render {

// Errors: Failure::internal when one has not.
inline Status check_films_ran(const scene::Scene& scene) {
  if (!scene::has_idle_film(scene)) return Done{};
  return fail(Failure::internal, "expected scene::run_films() before, got a simulated film that has not run");
}

}  // namespace shabon::render
