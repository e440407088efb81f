// Camera and picture of a scene file -> the renderer's.
#pragma once

#include "shabon/scene/resources.h"
#include "shabon/scene/scene.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

Camera compile_camera(const CameraDesc& camera, const ImageDesc& image);

PixelFilter compile_filter(const ImageDesc& image);

// Reads the lamp of the white balance; one that cannot serve becomes a problem.
Development compile_development(const ImageDesc& image, const Path& path, const Resources& resources,
                                Problems& problems);

}  // namespace shabon::scene
