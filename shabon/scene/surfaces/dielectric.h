// Surface: the boundary of a clear solid or liquid, smooth or rough (GGX), bare or coated.
#pragma once

#include "shabon/scene/surfaces/coating.h"

namespace shabon::scene {

struct DielectricSurface {
  Coating coating;
  NumberTexture roughness;  // GGX alpha; 0 is smooth
};

}  // namespace shabon::scene
