// Pictures for textures, from a file.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/scene/resources.h"

namespace shabon::api {

// PNG (its numbers as they stand, 0..1, in the file's depth), OpenEXR or Radiance HDR (linear), told apart by content.
// Errors as io::read_texture_image().
Result<scene::TextureFile> read_texture(const std::filesystem::path& path);

}  // namespace shabon::api
