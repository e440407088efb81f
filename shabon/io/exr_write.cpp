// OpenEXR pictures out of memory.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>

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

Imf::Header make_header(const RgbImage& image, const Metadata& metadata) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  const auto point = [](Chromaticity c) { return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y)); };
  const RgbPrimaries& srgb = srgb_primaries;
  Imf::addChromaticities(header, {point(srgb.red), point(srgb.green), point(srgb.blue), point(srgb.white)});
  for (const auto& [name, text] : metadata) header.insert(name, Imf::StringAttribute(text));
  return header;
}

}  // namespace

Result<std::string> encode_exr(const RgbImage& image, const Metadata& metadata) try {
  if (auto error = refuse_contents(image.width, image.height, image.rgb.size(), metadata)) return *error;
  const Imf::Header header = make_header(image, metadata);
  MemoryOutput stream;
  {
    Imf::OutputFile file(stream, header, 0);
    Imf::FrameBuffer buffer;
    const std::size_t pixel = 3 * sizeof(float), row = pixel * static_cast<std::size_t>(image.width);
    for (std::size_t i = 0; i < 3; ++i)  // the library takes a pointer to non-const but only reads
      buffer.insert(
          std::string(1, "RGB"[i]),
          Imf::Slice(Imf::FLOAT, const_cast<char*>(reinterpret_cast<const char*>(image.rgb.data() + i)), pixel, row));
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
  }
  return stream.take();
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
