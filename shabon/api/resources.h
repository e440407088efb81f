// What a scene takes from outside, from the file system.
#pragma once

#include <filesystem>
#include <functional>

#include "shabon/scene/resources.h"

namespace shabon::api {

// For scene::compile() and load_scene(): media as medium_resolver() finds them, pictures by io::read_image(), textures
// by read_texture(), reflectances by read_reflectance_file(), relative paths from `folder`, which is that of the scene
// file. `opened`, if there is one, is told of every file before it is opened.
scene::Resources file_resources(const std::filesystem::path& folder,
                                std::function<void(const std::filesystem::path&)> opened = {});

}  // namespace shabon::api
