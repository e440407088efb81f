// Where the picture readers put their pixels. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "shabon/base/result.h"
#include "shabon/io/image.h"
#include "shabon/io/primaries.h"

namespace shabon::io {

// Larger picture files are refused.
inline constexpr std::size_t picture_max_bytes = std::size_t{1} << 31;

// One error about a picture.
Diagnostics picture_error(const std::string& source, std::string message, Failure failure = Failure::content);

// The error for a size that no reader takes, or nothing.
std::optional<Diagnostics> refuse_size(const std::string& source, std::int64_t width, std::int64_t height);

// The error (Failure::internal) for a picture to be written whose sizes do not fit together or whose metadata names are
// not 1..79 printable ASCII characters, or nothing.
std::optional<Diagnostics> refuse_contents(int width, int height, std::size_t values, const Metadata& metadata);

// Takes the pixels of a picture in reading order: refuses NaN and infinity, converts to sRGB's primaries, turns
// negatives into 0. Memory is touched as pixels arrive, so a header that lies about the size costs nothing.
class PixelSink {
 public:
  PixelSink(const std::string& source, int width, int height, std::optional<Matrix3> to_srgb);

  void add(std::array<float, 3> rgb);  // keeps the first error
  void add_black(std::int64_t pixels);
  bool ok() const { return errors_.empty(); }
  Result<RgbImage> take();  // when all pixels are in

 private:
  void refuse(float value, std::size_t channel);

  const std::string& source_;
  std::optional<Matrix3> to_srgb_;
  RgbImage image_;
  Diagnostics errors_;
};

}  // namespace shabon::io
