// Scenes for the tests of light transport, as lists: arrangements of bubbles, surroundings, and both together.
#pragma once

#include <string>
#include <vector>

#include "shabon/scene/compile.h"

namespace shabon::testing_scenes {

struct Arrangement {
  std::string name;
  std::vector<scene::ObjectDesc> bubbles;
  bool lossless = true;
  bool real_angles = true;  // no film of lower index than the medium
};

// Whether the model can compute it: `airy` alone knows films of several layers.
bool computable(const Arrangement& arrangement, optics::Interference model);

const std::vector<Arrangement>& arrangements();
const Arrangement& arrangement(const std::string& name);

struct Surroundings {
  std::string name;
  scene::EnvironmentDesc light;
};

const std::vector<Surroundings>& surroundings();
const scene::EnvironmentDesc& light(const std::string& name);

scene::EnvironmentDesc uniform(const std::string& illuminant, double scale = 1);

// The arrangement in front of a camera that sees all of it; 8 by 8 pixels.
scene::SceneDesc scene_of(const Arrangement& arrangement, const scene::EnvironmentDesc& light);

scene::ObjectDesc bubble(math::Vec3d center, double radius, std::string medium, film::ThicknessModel thickness);

// The compiled scene; throws std::invalid_argument with the first problem.
scene::Scene compiled(const scene::SceneDesc& description);

}  // namespace shabon::testing_scenes
