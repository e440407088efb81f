// Surface: a thin pane with any stack, thick layers included, and the scene's medium on both sides. Light crosses
// straight: the pane's own thickness is not seen.
#pragma once

#include "shabon/optics/stack.h"

namespace shabon::scene {

struct PaneSurface {
  optics::Stack stack;  // coherent and incoherent layers
};

}  // namespace shabon::scene
