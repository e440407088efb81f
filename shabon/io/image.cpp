#include "shabon/io/image.h"

#include <array>

#include "shabon/io/file.h"
#include "shabon/io/pixel_sink.h"

namespace shabon::io {

namespace {

struct Signature {
  std::string_view name, bytes;
};

constexpr std::string_view exr_signature("\x76\x2F\x31\x01", 4), hdr_signature("#?");

// Kinds that people try, to name them instead of calling them unknown.
constexpr std::array known_signatures{
    Signature{"PNG", "\x89PNG"},     Signature{"JPEG", "\xFF\xD8\xFF"}, Signature{"TIFF", {"II*\0", 4}},
    Signature{"TIFF", {"MM\0*", 4}}, Signature{"GIF", "GIF8"},          Signature{"PFM", "PF\n"},
    Signature{"DirectDraw", "DDS "},
};

}  // namespace

Result<RgbImage> read_image(const std::filesystem::path& path) {
  const std::string source = path.string();
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  if (bytes->starts_with(exr_signature)) return decode_exr(*bytes, source);
  if (bytes->starts_with(hdr_signature)) return decode_hdr(*bytes, source);
  constexpr std::string_view expected = "expected a picture in OpenEXR (.exr) or Radiance (.hdr)";
  if (bytes->empty()) return picture_error(source, std::string(expected) + ", got an empty file");
  for (const Signature& signature : known_signatures)
    if (bytes->starts_with(signature.bytes))
      return picture_error(source, std::string(expected) + ", got " + std::string(signature.name));
  return picture_error(source, std::string(expected) + ", got something else");
}

}  // namespace shabon::io
