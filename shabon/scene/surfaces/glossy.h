// Surface: a diffuse base under a clear boundary, smooth or rough (GGX), bare or coated: lacquer, plastic, wet asphalt.
#pragma once

#include "shabon/scene/surfaces/coating.h"

namespace shabon::scene {

struct GlossySurface {
  Coating coating;  // ends in the medium that the base is embedded in
  NumberTexture roughness;
  ReflectanceTexture base;
};

}  // namespace shabon::scene
