#include "shabon/api/texture_file.h"

#include <utility>

#include "shabon/io/texture_image.h"

namespace shabon::api {

Result<scene::TextureFile> read_texture(const std::filesystem::path& path) {
  Result<io::TextureImage> image = io::read_texture_image(path);
  if (!image) return image.errors();
  scene::TextureFile texture;
  texture.raster = {image->width, image->height, image->channels, std::move(image->values)};
  texture.whole_numbers = image->whole_numbers;
  texture.bits = image->bits;
  texture.negatives = image->negatives;
  return texture;
}

}  // namespace shabon::api
