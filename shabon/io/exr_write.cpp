// OpenEXR pictures out of memory.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <span>
#include <string>
#include <string_view>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/io/pixel_sink.h"

namespace shabon::io {

namespace {

class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}
  void write(const char from[], int count) override {
    const auto length = static_cast<std::size_t>(count);
    if (position_ + length > bytes_.size()) bytes_.resize(position_ + length);
    std::memcpy(bytes_.data() + position_, from, length);
    position_ += length;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::uint64_t position_ = 0;
};

Imf::Header make_header(int width, int height, std::string_view channels, const Metadata& metadata) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char name : channels) header.channels().insert(std::string(1, name), Imf::Channel(Imf::FLOAT));
  for (const auto& [name, text] : metadata) header.insert(name, Imf::StringAttribute(text));
  return header;
}

// `values` hold the channels of a pixel side by side, in the order of their names.
std::string encode(const Imf::Header& header, std::string_view channels, std::span<const float> values) {
  const Imath::Box2i& window = header.dataWindow();
  MemoryOutput stream;
  {
    Imf::OutputFile file(stream, header, 0);
    Imf::FrameBuffer buffer;
    const std::size_t pixel = channels.size() * sizeof(float);
    const std::size_t row = pixel * static_cast<std::size_t>(window.max.x + 1);
    for (std::size_t i = 0; i < channels.size(); ++i)  // the library takes a pointer to non-const but only reads
      buffer.insert(
          std::string(1, channels[i]),
          Imf::Slice(Imf::FLOAT, const_cast<char*>(reinterpret_cast<const char*>(values.data() + i)), pixel, row));
    file.setFrameBuffer(buffer);
    file.writePixels(window.max.y + 1);
  }
  return stream.take();
}

}  // namespace

Result<std::string> encode_exr(const RgbImage& image, const Metadata& metadata) try {
  if (auto error = refuse_contents(image.width, image.height, image.rgb.size(), metadata)) return *error;
  Imf::Header header = make_header(image.width, image.height, "RGB", metadata);
  const auto point = [](Chromaticity c) { return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y)); };
  const RgbPrimaries& srgb = srgb_primaries;
  Imf::addChromaticities(header, {point(srgb.red), point(srgb.green), point(srgb.blue), point(srgb.white)});
  return encode(header, "RGB", image.rgb);
} catch (const std::exception& problem) {
  return fail(Failure::internal, std::string("writing OpenEXR: ") + problem.what());
}

Result<std::string> encode_exr_numbers(int width, int height, std::span<const float> values, Layout layout,
                                       const Metadata& metadata) try {
  if (auto error = refuse_contents(width, height, 3 * values.size(), metadata)) return *error;
  Imf::Header header = make_header(width, height, "Y", metadata);
  if (layout == Layout::cube) Imf::addEnvmap(header, Imf::ENVMAP_CUBE);
  return encode(header, "Y", values);
} catch (const std::exception& problem) {
  return fail(Failure::internal, std::string("writing OpenEXR: ") + problem.what());
}

Status write_exr(const std::filesystem::path& path, const RgbImage& image, const Metadata& metadata) {
  Result<std::string> bytes = encode_exr(image, metadata);
  if (!bytes) {
    Diagnostics errors = bytes.errors();
    for (Diagnostic& error : errors) error.source = path.string();
    return errors;
  }
  return write_file_atomically(path, *bytes);
}

}  // namespace shabon::io
