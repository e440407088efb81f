#include "shabon/io/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include "shabon/base/text.h"

namespace shabon::io {

namespace {

constexpr std::int64_t largest_chunk_bytes = std::int64_t{1} << 30;  // what the library may hold for decoding
constexpr std::int64_t most_rows_in_chunk = 256;                     // DWAB's; every other compression has fewer
constexpr std::size_t first_attribute = 8;                           // after the magic number and the version

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return value;
}

// Walks the attributes (name NUL, type NUL, 4-byte size, value) of every header: the library allocates what a size
// claims before it reads. False when one reaches past the end.
bool attributes_fit(std::string_view bytes) {
  if (bytes.size() < first_attribute) return false;
  const bool several = Imf::isMultiPart(static_cast<int>(little_endian(bytes, 4)));
  std::size_t at = first_attribute;
  for (bool header_empty = true;;) {
    if (at >= bytes.size()) return false;
    if (bytes[at] == '\0') {  // the header's end
      ++at;
      if (!several || header_empty) return true;
      header_empty = true;
      continue;
    }
    header_empty = false;
    for (int text = 0; text < 2; ++text) {
      const std::size_t end = bytes.find('\0', at);
      if (end == std::string_view::npos) return false;
      at = end + 1;
    }
    if (bytes.size() - at < 4) return false;
    const std::uint32_t size = little_endian(bytes, at);
    at += 4;
    if (size > bytes.size() - at) return false;
    at += size;
  }
}

Imf::Header first_header(std::string_view bytes, const std::string& source) {
  MemoryInput stream(bytes, source);
  stream.seekg(first_attribute);
  Imf::Header header;
  int version = static_cast<int>(little_endian(bytes, 4));
  header.readFrom(stream, version);
  return header;
}

std::int64_t bytes_per_pixel(const Imf::Header& header) {
  std::int64_t total = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    total += channel.channel().type == Imf::HALF ? 2 : 4;
  return std::max<std::int64_t>(total, 12);  // at least what the reader itself asks for
}

// Tiles: their table must fit into the file, and a row of them into memory.
std::optional<Diagnostics> refuse_tiles(const Imf::Header& header, const std::string& source, std::size_t file_bytes) {
  if (!header.hasTileDescription()) return {};
  const Imf::TileDescription tiles = header.tileDescription();
  const Window data(header.dataWindow());
  const std::int64_t x_size = tiles.xSize, y_size = tiles.ySize;
  if (x_size < 1 || y_size < 1) return picture_error(source, "tiles without pixels");
  const std::int64_t across = (data.width() + x_size - 1) / x_size, down = (data.height() + y_size - 1) / y_size;
  if (across * down > static_cast<std::int64_t>(file_bytes / sizeof(std::uint64_t)))
    return picture_error(source, "truncated: the table of tiles is longer than the file");
  if (y_size > largest_chunk_bytes ||
      std::max(data.width(), x_size) > largest_chunk_bytes / y_size / bytes_per_pixel(header))
    return picture_error(source,
                         "tiles of " + std::to_string(x_size) + "x" + std::to_string(y_size) + " pixels are too large");
  return {};
}

std::optional<Diagnostics> refuse_header(const Imf::Header& header, const std::string& source, std::size_t file_bytes) {
  const Window data(header.dataWindow()), display(header.displayWindow());
  for (const Window& window : {data, display})
    if (auto error = refuse_size(source, window.width(), window.height())) return error;
  if (data.left >= display.right || data.right <= display.left || data.top >= display.bottom ||
      data.bottom <= display.top)
    return picture_error(source, "the data window lies outside the display window");
  if (data.width() * std::min(data.height(), most_rows_in_chunk) > largest_chunk_bytes / bytes_per_pixel(header))
    return picture_error(source, "too many channels");
  return refuse_tiles(header, source, file_bytes);
}

}  // namespace

std::string exr_channel_names(const Imf::Header& header) {
  std::string found;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    found += (found.empty() ? "" : ", ") + printable(channel.name(), 60);
  return printable(found.empty() ? "none" : found, 200);
}

Result<Imf::Header> checked_exr_header(std::string_view bytes, const std::string& source) {
  if (!Imf::isImfMagic(bytes.size() < 4 ? "...." : bytes.data()))
    return picture_error(source, "not an OpenEXR picture");
  if (!attributes_fit(bytes)) return picture_error(source, "the picture's header is truncated or damaged");
  Imf::Header header = first_header(bytes, source);
  if (auto error = refuse_header(header, source, bytes.size())) return *error;
  return header;
}

}  // namespace shabon::io
