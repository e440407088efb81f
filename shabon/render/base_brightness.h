// How bright the base light of a scene is in each direction, as a latitude-longitude table.
#pragma once

#include <vector>

#include "shabon/scene/environment.h"

namespace shabon::render {

struct BaseBrightness {
  int width = 0, height = 0;
  std::vector<double> brightness;  // the mean over each cell, rows from the top
  double irradiance = 0;           // its integral over all directions
};

// `channel_y`: Y of each of the environment's channels. Pictures are averaged over whole cells: no texel, however
// small, is missed.
BaseBrightness base_brightness(const scene::Environment& environment, const std::vector<double>& channel_y);

// The solid angle of a cell in `row`.
double cell_solid_angle(int width, int height, int row);

}  // namespace shabon::render
