// Pictures as files: OpenEXR and Radiance HDR in, PNG and OpenEXR out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::io {

struct RgbImage {
  int width = 0, height = 0;
  std::vector<float> rgb;  // 3 width height values, rows from top to bottom, linear sRGB
  int negatives = 0;       // how many values were below zero in the file and became 0
};

struct Rgb8Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  // rows from top to bottom, encoded sRGB
};

// Names and texts stored beside the picture, in this order.
using Metadata = std::vector<std::pair<std::string, std::string>>;

inline constexpr int image_max_side = 65536;
inline constexpr std::int64_t image_max_pixels = std::int64_t{1} << 28;

// Linear sRGB from the channels R, G and B (half, float or integer). The picture is the display window: what the data
// window leaves out is black. A `chromaticities` attribute is honoured: the colour (XYZ) stays, without adaptation, and
// is written in sRGB's primaries. Errors: Failure::file when it cannot be read; Failure::content when it is damaged,
// truncated, too large, lacks a channel (the message names those found) or holds NaN or infinity (the pixel is named).
Result<RgbImage> read_exr(const std::filesystem::path& path);

// Radiance pictures (FORMAT=32-bit_rle_rgbe), flat or with either run length coding, rows top to bottom (-Y h +X w).
// EXPOSURE and COLORCORR are divided out. PRIMARIES is not applied: the values count as linear sRGB. Errors as
// read_exr.
Result<RgbImage> read_hdr(const std::filesystem::path& path);

// Either, told apart by content.
Result<RgbImage> read_image(const std::filesystem::path& path);

// The same from memory; `source` names the picture in errors.
Result<RgbImage> decode_exr(std::string_view bytes, const std::string& source);
Result<RgbImage> decode_hdr(std::string_view bytes, const std::string& source);

// 8-bit PNG marked as sRGB; metadata become text chunks. `rgb` holds 3 width height values; `pixels_per_inch` above 0
// tells how large to print it. Errors: Failure::file as write_file_atomically; Failure::internal when the sizes do not
// fit or a metadata name is not 1..79 printable letters.
Status write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb,
                 const Metadata& metadata, double pixels_per_inch = 0);
Result<std::string> encode_png(int width, int height, std::span<const std::uint8_t> rgb, const Metadata& metadata,
                               double pixels_per_inch = 0);

// 16-bit grey, 0..65535 as they stand: numbers, no light. Errors as encode_png.
Result<std::string> encode_png16(int width, int height, std::span<const std::uint16_t> grey, const Metadata& metadata);

// What a picture of numbers lies on: a cube is marked as OpenEXR's `envmap`. Latitude-longitude pictures are not: those
// of OpenEXR begin at another meridian.
enum class Layout { flat, cube };

// One float channel Y without loss (ZIP), such as thickness in nm; `values` row by row from the top. Errors as
// encode_png.
Result<std::string> encode_exr_numbers(int width, int height, std::span<const float> values, Layout layout,
                                       const Metadata& metadata);

// Float R, G, B without loss (ZIP), with sRGB's chromaticities; metadata become string attributes. Errors as write_png.
Status write_exr(const std::filesystem::path& path, const RgbImage& image, const Metadata& metadata);
Result<std::string> encode_exr(const RgbImage& image, const Metadata& metadata);

// Any PNG as 8-bit sRGB; transparency over black. Errors as read_exr.
Result<Rgb8Image> read_png(const std::filesystem::path& path);
Result<Rgb8Image> decode_png(std::string_view bytes, const std::string& source);

}  // namespace shabon::io
