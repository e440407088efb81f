#include "shabon/api/texture_file.h"

#include <fstream>
#include <string>

#include "shabon/io/image.h"

namespace shabon::api {

namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

bool is_png(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;  // a FIFO would be waited for
  std::ifstream stream(path, std::ios::binary);
  std::string start(png_signature.size(), '\0');
  return stream.read(start.data(), static_cast<std::streamsize>(start.size())) && start == png_signature;
}

}  // namespace

Result<scene::TextureFile> read_texture(const std::filesystem::path& path) {
  scene::TextureFile texture;
  if (is_png(path)) {
    const Result<io::Rgb8Image> image = io::read_png(path);
    if (!image) return image.errors();
    constexpr float largest_byte = 255;
    texture.raster = {image->width, image->height, 3, {}};
    texture.raster.values.reserve(image->rgb.size());
    for (const std::uint8_t byte : image->rgb) texture.raster.values.push_back(static_cast<float>(byte) / largest_byte);
    texture.whole_numbers = true;
    texture.bits = 8;
    return texture;
  }
  Result<io::RgbImage> image = io::read_image(path);
  if (!image) return image.errors();
  texture.raster = {image->width, image->height, 3, std::move(image->rgb)};
  texture.negatives = image->negatives;
  return texture;
}

}  // namespace shabon::api
