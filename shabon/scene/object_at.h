// Whether a point lies on a surface: rays cannot start there, as neither side is theirs.
#pragma once

#include <optional>

#include "shabon/math/vec.h"
#include "shabon/scene/scene.h"

namespace shabon::scene {

// The place in the scene file of an object on which the point lies, to a billionth of its size. Bubbles do not count:
// from their walls a ray starts as from any other place.
std::optional<int> object_at(const Scene& scene, const math::Vec3d& point);

}  // namespace shabon::scene
