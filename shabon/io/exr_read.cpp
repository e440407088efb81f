// OpenEXR pictures into memory: colours, or the numbers of one channel.
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include "shabon/base/text.h"
#include "shabon/io/exr_file.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/io/texture_image.h"

namespace shabon::io {

namespace {

std::optional<Diagnostics> refuse_channels(const Imf::Header& header, const std::string& source) {
  std::string missing;
  for (const char* name : {"R", "G", "B"})
    if (!header.channels().findChannel(name)) missing += (missing.empty() ? "" : ", ") + std::string(name);
  if (missing.empty()) return {};
  return picture_error(
      source, "expected the channels R, G and B; missing: " + missing + "; found: " + exr_channel_names(header));
}

Result<std::optional<Matrix3>> conversion_to_srgb(const Imf::Header& header, const std::string& source) {
  if (!Imf::hasChromaticities(header)) return std::optional<Matrix3>();
  const Imf::Chromaticities& given = Imf::chromaticities(header);
  const auto point = [](const Imath::V2f& v) { return Chromaticity{v.x, v.y}; };
  const auto matrix = rgb_to_srgb({point(given.red), point(given.green), point(given.blue), point(given.white)});
  if (!matrix) return picture_error(source, "the chromaticities attribute describes no colour space");
  return is_identity(*matrix) ? std::optional<Matrix3>() : matrix;
}

// The channel whose numbers count; empty where the picture has all of R, G and B, nothing where no choice is clear.
std::optional<std::string> number_channel(const Imf::Header& header) {
  const Imf::ChannelList& channels = header.channels();
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  if (has("RY") || has("BY")) return {};  // colours as luminance and differences
  if (has("R") && has("G") && has("B")) return "";
  for (const char* name : {"Y", "R"})
    if (has(name) && !has("G") && !has("B")) return name;
  const auto first = channels.begin();
  if (first == channels.end()) return {};
  auto second = first;
  if (++second != channels.end()) return {};
  return first.name();
}

Result<TextureImage> read_numbers(Imf::InputFile& file, const Imf::Header& header, const std::string& channel,
                                  const std::string& source) {
  const Window display(header.displayWindow());
  TextureImage image{static_cast<int>(display.width()), static_cast<int>(display.height()), 1, {}};
  image.values.reserve(static_cast<std::size_t>(display.width() * display.height()));
  Diagnostics errors;
  const auto take = [&](const float* value) {
    if (!errors.empty()) return;
    if (std::isfinite(*value) && *value >= 0) return image.values.push_back(std::abs(*value));
    const auto width = static_cast<std::size_t>(image.width), at = image.values.size();
    errors = picture_error(source, "pixel (" + std::to_string(at % width) + ", " + std::to_string(at / width) +
                                       "), counted from the top left, is " +
                                       (std::isnan(*value)   ? "not a number"
                                        : std::isinf(*value) ? "infinite"
                                                             : "negative") +
                                       " in " + printable(channel, 60));
  };
  read_exr_pixels(
      file, header, {channel}, take,
      [&](std::int64_t pixels) { image.values.resize(image.values.size() + static_cast<std::size_t>(pixels), 0.0f); },
      [&] { return errors.empty(); });
  if (!errors.empty()) return errors;
  return image;
}

Diagnostics out_of_memory(const std::string& source) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
}

Diagnostics damaged(const std::string& source, const std::exception& problem) {
  return picture_error(source, std::string("damaged or truncated OpenEXR picture: ") + problem.what());
}

}  // namespace

Result<RgbImage> decode_exr(std::string_view bytes, const std::string& source) try {
  const Result<Imf::Header> header = checked_exr_header(bytes, source);
  if (!header) return header.errors();
  if (auto error = refuse_channels(*header, source)) return *error;
  const auto to_srgb = conversion_to_srgb(*header, source);
  if (!to_srgb) return to_srgb.errors();
  MemoryInput stream(bytes, source);
  Imf::InputFile file(stream, 0);
  const Window display(header->displayWindow());
  PixelSink sink(source, static_cast<int>(display.width()), static_cast<int>(display.height()), *to_srgb);
  read_exr_pixels(
      file, *header, {"R", "G", "B"},
      [&](const float* pixel) {
        sink.add({pixel[0], pixel[1], pixel[2]});
      },
      [&](std::int64_t pixels) { sink.add_black(pixels); }, [&] { return sink.ok(); });
  return sink.take();
} catch (const std::bad_alloc&) {
  return out_of_memory(source);
} catch (const std::exception& problem) {
  return damaged(source, problem);
}

Result<TextureImage> decode_exr_texture(std::string_view bytes, const std::string& source) try {
  const Result<Imf::Header> header = checked_exr_header(bytes, source);
  if (!header) return header.errors();
  const std::optional<std::string> channel = number_channel(*header);
  if (!channel)
    return picture_error(source,
                         "expected one channel of numbers, or R, G and B; found: " + exr_channel_names(*header));
  if (channel->empty()) {
    Result<RgbImage> colors = decode_exr(bytes, source);
    if (!colors) return colors.errors();
    return texture_of(std::move(*colors));
  }
  MemoryInput stream(bytes, source);
  Imf::InputFile file(stream, 0);
  return read_numbers(file, *header, *channel, source);
} catch (const std::bad_alloc&) {
  return out_of_memory(source);
} catch (const std::exception& problem) {
  return damaged(source, problem);
}

Result<RgbImage> read_exr(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  return decode_exr(*bytes, path.string());
}

}  // namespace shabon::io
