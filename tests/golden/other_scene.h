// Scenes that differ from themselves by a little.
#pragma once

#include "shabon/scene/scene.h"

namespace shabon::test {

// All thicknesses of films, coatings and coherent layers of panes times `factor`; how many there were.
int scale_layers(scene::Scene& scene, double factor);

// Puts glass with the same index at 550 nm, and at all other wavelengths, behind every boundary that bends wavelengths
// apart; how many there were.
int stop_dispersion(scene::Scene& scene);

}  // namespace shabon::test
