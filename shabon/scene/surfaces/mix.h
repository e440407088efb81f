// Surfaces made of other ones: two side by side below what the eye resolves, or one with holes.
#pragma once

#include "shabon/scene/texture.h"

namespace shabon::scene {

struct MixSurface {
  int first = 0, second = 0;  // Scene::surfaces, both listed before this one
  NumberTexture amount;       // of the second, 0..1
};

struct MaskSurface {
  int surface = 0;  // Scene::surfaces, listed before this one
  NumberTexture opacity;
};

}  // namespace shabon::scene
