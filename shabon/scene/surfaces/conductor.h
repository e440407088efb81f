// Surface: a metal or any other medium that lets no light through, smooth or rough (GGX), bare or coated.
#pragma once

#include "shabon/scene/surfaces/coating.h"

namespace shabon::scene {

struct ConductorSurface {
  Coating coating;
  NumberTexture roughness;  // GGX alpha; 0 is smooth
};

}  // namespace shabon::scene
