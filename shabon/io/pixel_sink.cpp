#include "shabon/io/pixel_sink.h"

#include <cmath>
#include <utility>

namespace shabon::io {

Diagnostics picture_error(const std::string& source, std::string message, Failure failure) {
  Diagnostics errors = fail(failure, std::move(message));
  errors[0].source = source;
  return errors;
}

std::optional<Diagnostics> refuse_size(const std::string& source, std::int64_t width, std::int64_t height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width < 1 || height < 1) return picture_error(source, "a picture without pixels (" + size + ")");
  if (width > image_max_side || height > image_max_side || width * height > image_max_pixels)
    return picture_error(source, "a picture of " + size + " pixels is too large; at most " +
                                     std::to_string(image_max_side) + " a side and " +
                                     std::to_string(image_max_pixels) + " in all");
  return {};
}

std::optional<Diagnostics> refuse_contents(int width, int height, std::size_t values, const Metadata& metadata) {
  constexpr std::size_t longest_name = 79;  // PNG's limit; the same names go into every format
  if (auto error = refuse_size({}, width, height)) {
    (*error)[0].failure = Failure::internal;
    return error;
  }
  if (values != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return fail(Failure::internal, "the picture's values do not fit its size");
  for (const auto& [name, text] : metadata) {
    bool printable_name = !name.empty() && name.size() <= longest_name && name.front() != ' ' && name.back() != ' ';
    for (char c : name) printable_name = printable_name && c >= ' ' && c <= '~';
    if (!printable_name) return fail(Failure::internal, "a metadata name must be 1 to 79 printable characters");
  }
  return {};
}

PixelSink::PixelSink(const std::string& source, int width, int height, std::optional<Matrix3> to_srgb)
    : source_(source), to_srgb_(to_srgb) {
  image_.width = width;
  image_.height = height;
  image_.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void PixelSink::add(std::array<float, 3> rgb) {
  if (!ok()) return;
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isfinite(rgb[i])) return refuse(rgb[i], i);
  if (to_srgb_) {
    const std::array<double, 3> given{rgb[0], rgb[1], rgb[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = (*to_srgb_)[i];
      rgb[i] = static_cast<float>(row[0] * given[0] + row[1] * given[1] + row[2] * given[2]);
      if (!std::isfinite(rgb[i])) return refuse(rgb[i], i);
    }
  }
  for (float& value : rgb) {
    if (value < 0) ++image_.negatives;
    image_.rgb.push_back(value > 0 ? value : 0);
  }
}

void PixelSink::add_black(std::int64_t pixels) {
  image_.rgb.resize(image_.rgb.size() + 3 * static_cast<std::size_t>(pixels), 0.0f);
}

void PixelSink::refuse(float value, std::size_t channel) {
  const std::size_t pixel = image_.rgb.size() / 3, width = static_cast<std::size_t>(image_.width);
  errors_ = picture_error(source_, "pixel (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) +
                                       "), counted from the top left, is " +
                                       (std::isnan(value) ? "not a number" : "infinite") + " in " + "RGB"[channel]);
}

Result<RgbImage> PixelSink::take() {
  if (!ok()) return errors_;
  return std::move(image_);
}

}  // namespace shabon::io
