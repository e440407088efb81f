// The spectra of all lamps of a scene, each once.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "shabon/color/spectrum.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/resources.h"

namespace shabon::scene {

class LampChannels {
 public:
  LampChannels(const Resources& resources, Problems& problems) : resources_(resources), problems_(problems) {}

  // One channel for each lamp that is used, whatever spelling its name has. `light` is what names the lamp. Lamps that
  // cannot be found become problems and give no light.
  int of(const std::string& illuminant, const Path& light);

  // Red, green and blue of a picture under its lamp, (22): the first of three channels.
  int of_picture();

  std::vector<color::Spectrum> spectra;  // radiance per nm at 1 nm; a lamp of scale 1 has Y = 1

 private:
  const Resources& resources_;
  Problems& problems_;
  std::map<std::string, int> channel_of_;       // by what the scene says
  std::map<std::string, int> channel_of_lamp_;  // by the lamp's own name
};

}  // namespace shabon::scene
