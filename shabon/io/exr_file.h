// OpenEXR pictures in memory, opened with care: the library believes the sizes a header claims, so they are checked
// before it may. Inside the room only; the functions throw what the library throws.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include "shabon/base/result.h"
#include "shabon/io/pixel_sink.h"

namespace shabon::io {

struct Window {  // half open, in the file's pixels; 64 bits: no sum of corners overflows
  std::int64_t left = 0, top = 0, right = 0, bottom = 0;
  explicit Window(const Imath::Box2i& box)
      : left(box.min.x), top(box.min.y), right(std::int64_t{box.max.x} + 1), bottom(std::int64_t{box.max.y} + 1) {}
  std::int64_t width() const { return right - left; }
  std::int64_t height() const { return bottom - top; }
};

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

// The first header, its attributes and sizes looked through.
Result<Imf::Header> checked_exr_header(std::string_view bytes, const std::string& source);

// The names of its channels, for messages.
std::string exr_channel_names(const Imf::Header& header);

inline constexpr int exr_rows_at_once = 64;

// Reads the rows that the display window shows, a few at a time, and hands its pixels on: pixel(values) with one value
// per name, blank(count) for what the data window leaves out. Goes on while more() says so.
template <class Pixel, class Blank, class More>
void read_exr_pixels(Imf::InputFile& file, const Imf::Header& header, const std::vector<std::string>& names,
                     const Pixel& pixel, const Blank& blank, const More& more) {
  const Window data(header.dataWindow()), display(header.displayWindow());
  const std::int64_t first = std::max(data.top, display.top), end = std::min(data.bottom, display.bottom);
  const std::int64_t left = std::max(data.left, display.left), right = std::min(data.right, display.right);
  const std::size_t count = names.size(), row_values = count * static_cast<std::size_t>(data.width());
  std::vector<float> rows(row_values * static_cast<std::size_t>(std::min<std::int64_t>(exr_rows_at_once, end - first)));
  blank((first - display.top) * display.width());
  for (std::int64_t top = first; top < end && more(); top += exr_rows_at_once) {
    const std::int64_t bottom = std::min(top + exr_rows_at_once, end);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < count; ++i)
      buffer.insert(
          names[i],
          Imf::Slice::Make(Imf::FLOAT, rows.data() + i, Imath::V2i(static_cast<int>(data.left), static_cast<int>(top)),
                           data.width(), bottom - top, count * sizeof(float), row_values * sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(static_cast<int>(top), static_cast<int>(bottom - 1));
    for (std::int64_t y = top; y < bottom; ++y) {
      const float* row = rows.data() + static_cast<std::size_t>(y - top) * row_values;
      blank(left - display.left);
      for (std::int64_t x = left; x < right; ++x) pixel(row + count * static_cast<std::size_t>(x - data.left));
      blank(display.right - right);
    }
  }
  blank((display.bottom - end) * display.width());
}

}  // namespace shabon::io
