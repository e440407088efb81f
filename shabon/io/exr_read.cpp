// OpenEXR pictures into memory. The library believes the sizes a header claims, so they are checked before it may.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include "shabon/base/text.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/io/pixel_sink.h"

namespace shabon::io {

namespace {

constexpr std::int64_t largest_chunk_bytes = std::int64_t{1} << 30;  // what the library may hold for decoding
constexpr std::int64_t most_rows_in_chunk = 256;                     // DWAB's; every other compression has fewer
constexpr std::size_t first_attribute = 8;                           // after the magic number and the version
constexpr int rows_at_once = 64;

class MemoryInput final : public Imf::IStream {
 public:
  MemoryInput(std::string_view bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (count < 0 || position_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - position_)
      throw Iex::InputExc("the file is truncated");
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::uint64_t position_ = 0;
};

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

struct Window {  // half open, in the file's pixels; 64 bits: no sum of corners overflows
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
  explicit Window(const Imath::Box2i& box)
      : left(box.min.x), top(box.min.y), right(std::int64_t{box.max.x} + 1), bottom(std::int64_t{box.max.y} + 1) {}
  std::int64_t width() const { return right - left; }
  std::int64_t height() const { return bottom - top; }
};

std::int64_t bytes_per_pixel(const Imf::Header& header) {
  std::int64_t total = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    total += channel.channel().type == Imf::HALF ? 2 : 4;
  return std::max<std::int64_t>(total, 12);  // at least what the reader itself asks for
}

std::optional<Diagnostics> refuse_channels(const Imf::Header& header, const std::string& source) {
  std::string found, missing;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    found += (found.empty() ? "" : ", ") + printable(channel.name(), 60);
  for (const char* name : {"R", "G", "B"})
    if (!header.channels().findChannel(name)) missing += (missing.empty() ? "" : ", ") + std::string(name);
  if (missing.empty()) return {};
  return picture_error(source, "expected the channels R, G and B; missing: " + missing +
                                   "; found: " + printable(found.empty() ? "none" : found, 200));
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
  if (auto error = refuse_tiles(header, source, file_bytes)) return error;
  return refuse_channels(header, source);
}

Result<std::optional<Matrix3>> conversion_to_srgb(const Imf::Header& header, const std::string& source) {
  if (!Imf::hasChromaticities(header)) return std::optional<Matrix3>();
  const Imf::Chromaticities& given = Imf::chromaticities(header);
  const auto point = [](const Imath::V2f& v) { return Chromaticity{v.x, v.y}; };
  const auto matrix = rgb_to_srgb({point(given.red), point(given.green), point(given.blue), point(given.white)});
  if (!matrix) return picture_error(source, "the chromaticities attribute describes no colour space");
  return is_identity(*matrix) ? std::optional<Matrix3>() : matrix;
}

// Reads the rows that the display window shows, a few at a time, and hands its pixels on.
void read_pixels(Imf::InputFile& file, const Window& data, const Window& display, PixelSink& sink) {
  const std::int64_t first = std::max(data.top, display.top), end = std::min(data.bottom, display.bottom);
  const std::int64_t left = std::max(data.left, display.left), right = std::min(data.right, display.right);
  const auto row_values = static_cast<std::size_t>(3 * data.width());
  std::vector<float> rows(row_values * static_cast<std::size_t>(std::min<std::int64_t>(rows_at_once, end - first)));
  sink.add_black((first - display.top) * display.width());
  for (std::int64_t top = first; top < end && sink.ok(); top += rows_at_once) {
    const std::int64_t bottom = std::min(top + rows_at_once, end);
    Imf::FrameBuffer buffer;
    for (int i = 0; i < 3; ++i)
      buffer.insert(
          std::string(1, "RGB"[i]),
          Imf::Slice::Make(Imf::FLOAT, rows.data() + i, Imath::V2i(static_cast<int>(data.left), static_cast<int>(top)),
                           data.width(), bottom - top, 3 * sizeof(float), row_values * sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(static_cast<int>(top), static_cast<int>(bottom - 1));
    for (std::int64_t y = top; y < bottom; ++y) {
      const float* row = rows.data() + static_cast<std::size_t>(y - top) * row_values;
      sink.add_black(left - display.left);
      for (std::int64_t x = left; x < right; ++x) {
        const float* pixel = row + 3 * (x - data.left);
        sink.add({pixel[0], pixel[1], pixel[2]});
      }
      sink.add_black(display.right - right);
    }
  }
  sink.add_black((display.bottom - end) * display.width());
}

}  // namespace

Result<RgbImage> decode_exr(std::string_view bytes, const std::string& source) try {
  if (!Imf::isImfMagic(bytes.size() < 4 ? "...." : bytes.data()))
    return picture_error(source, "not an OpenEXR picture");
  if (!attributes_fit(bytes)) return picture_error(source, "the picture's header is truncated or damaged");
  const Imf::Header header = first_header(bytes, source);
  if (auto error = refuse_header(header, source, bytes.size())) return *error;
  const auto to_srgb = conversion_to_srgb(header, source);
  if (!to_srgb) return to_srgb.errors();
  MemoryInput stream(bytes, source);
  Imf::InputFile file(stream, 0);
  const Window data(header.dataWindow()), display(header.displayWindow());
  PixelSink sink(source, static_cast<int>(display.width()), static_cast<int>(display.height()), *to_srgb);
  read_pixels(file, data, display, sink);
  return sink.take();
} catch (const std::bad_alloc&) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
} catch (const std::exception& problem) {
  return picture_error(source, std::string("damaged or truncated OpenEXR picture: ") + problem.what());
}

Result<RgbImage> read_exr(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  return decode_exr(*bytes, path.string());
}

}  // namespace shabon::io
