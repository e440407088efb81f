// The environment of a scene: lamps become channels, a picture becomes texels.
#pragma once

#include "shabon/scene/environment.h"
#include "shabon/scene/lamp_channels.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/resources.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

// Without its channels: those are `lamps`, which objects add to. Lamps that cannot be found are problems already and
// give no light; a picture that cannot be loaded becomes one.
Environment compile_environment(const EnvironmentDesc& description, const Path& path, const Resources& resources,
                                LampChannels& lamps, Problems& problems);

}  // namespace shabon::scene
