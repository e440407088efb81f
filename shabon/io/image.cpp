#include "shabon/io/image.h"

#include <array>
#include <string>
#include <utility>

#include "shabon/io/file.h"
#include "shabon/io/pixel_sink.h"
#include "shabon/io/texture_image.h"

namespace shabon::io {

namespace {

struct Signature {
  std::string_view name, bytes;
};

constexpr std::string_view exr_signature("\x76\x2F\x31\x01", 4), hdr_signature("#?"), png_signature("\x89PNG"),
    jpeg_signature("\xFF\xD8\xFF");

// Kinds that people try, to name them instead of calling them unknown.
constexpr std::array known_signatures{
    Signature{"PNG", png_signature}, Signature{"JPEG", jpeg_signature}, Signature{"TIFF", {"II*\0", 4}},
    Signature{"TIFF", {"MM\0*", 4}}, Signature{"GIF", "GIF8"},          Signature{"PFM", "PF\n"},
    Signature{"DirectDraw", "DDS "},
};

Diagnostics unknown_picture(std::string_view bytes, const std::string& source, const std::string& kinds) {
  const std::string expected = "expected a picture in " + kinds;
  if (bytes.empty()) return picture_error(source, expected + ", got an empty file");
  for (const Signature& signature : known_signatures)
    if (bytes.starts_with(signature.bytes))
      return picture_error(source, expected + ", got " + std::string(signature.name));
  return picture_error(source, expected + ", got something else");
}

}  // namespace

Result<RgbImage> read_image(const std::filesystem::path& path) {
  const std::string source = path.string();
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  if (bytes->starts_with(exr_signature)) return decode_exr(*bytes, source);
  if (bytes->starts_with(hdr_signature)) return decode_hdr(*bytes, source);
  return unknown_picture(*bytes, source, "OpenEXR (.exr) or Radiance (.hdr)");
}

Result<TextureImage> read_texture_image(const std::filesystem::path& path) {
  const std::string source = path.string();
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  if (bytes->starts_with(png_signature)) return decode_png_texture(*bytes, source);
  if (bytes->starts_with(jpeg_signature)) return decode_jpeg_texture(*bytes, source);
  if (bytes->starts_with(exr_signature)) return decode_exr_texture(*bytes, source);
  if (!bytes->starts_with(hdr_signature))
    return unknown_picture(*bytes, source, "PNG (.png), JPEG (.jpg), OpenEXR (.exr) or Radiance (.hdr)");
  Result<RgbImage> colors = decode_hdr(*bytes, source);
  if (!colors) return colors.errors();
  return texture_of(std::move(*colors));
}

TextureImage texture_of(RgbImage image) {
  TextureImage texture{image.width, image.height, 3, std::move(image.rgb)};
  texture.negatives = image.negatives;
  return texture;
}

}  // namespace shabon::io
