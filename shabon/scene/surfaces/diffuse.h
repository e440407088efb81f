// Surface: reflects alike into all directions (Lambert), on both sides.
#pragma once

#include "shabon/scene/texture.h"

namespace shabon::scene {

struct DiffuseSurface {
  ReflectanceTexture color;
};

}  // namespace shabon::scene
