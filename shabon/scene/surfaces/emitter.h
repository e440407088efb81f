// Surface: a lamp that shines alike into all directions of its front, or of both sides. It reflects nothing.
#pragma once

namespace shabon::scene {

struct EmitterSurface {
  int channel = 0;  // of Environment::channels
  double scale = 1;
  bool both_sides = false;
};

}  // namespace shabon::scene
