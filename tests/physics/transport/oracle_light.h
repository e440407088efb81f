// The surroundings as the scene file defines them: radiance from a direction at a wavelength.
#pragma once

#include "shabon/scene/scene_desc.h"

namespace shabon::oracle {

// Per nm; `direction` is a unit vector away from the scene. Constant and gradient bases, and softboxes.
double radiance(const scene::EnvironmentDesc& environment, const math::Vec3d& direction, double wavelength_nm);

}  // namespace shabon::oracle
