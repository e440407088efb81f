// The environment of a scene: lamps become channels, a picture becomes texels.
#pragma once

#include "shabon/scene/environment.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/resources.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

// Lamps that cannot be found are problems already and give no light; a picture that cannot be loaded becomes one.
Environment compile_environment(const EnvironmentDesc& description, const Path& path, const Resources& resources,
                                Problems& problems);

}  // namespace shabon::scene
