// PNG through libpng: the full interface to write (text chunks), the simplified one to read.
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/io/file.h"
#include "shabon/io/image.h"
#include "shabon/io/pixel_sink.h"
#include "shabon/io/png_limits.h"

namespace shabon::io {

namespace {

constexpr double metres_per_inch = 0.0254;

// libpng reports errors by longjmp: between setjmp and it there must be nothing with a destructor.
struct Output {
  std::string bytes;
  std::string message;
};

extern "C" void shabon_png_error(png_structp png, png_const_charp message) {
  try {
    static_cast<Output*>(png_get_error_ptr(png))->message = message;
  } catch (...) {
  }
  png_longjmp(png, 1);
}

extern "C" void shabon_png_warning(png_structp, png_const_charp) {}

extern "C" void shabon_png_write(png_structp png, png_bytep data, png_size_t size) {
  bool stored = true;
  try {
    static_cast<Output*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
  } catch (...) {
    stored = false;
  }
  if (!stored) png_error(png, "not enough memory");
}

extern "C" void shabon_png_flush(png_structp) {}

// Pixels as they stand in the file, rows from top to bottom.
struct Pixels {
  int width, height;
  int bits, color_type;
  const std::uint8_t* bytes;
  std::size_t row_bytes;
};

bool write_image(png_structp png, png_infop info, const Pixels& pixels, png_text* texts, int text_count,
                 png_uint_32 pixels_per_metre) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height), pixels.bits,
               pixels.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (pixels.color_type == PNG_COLOR_TYPE_RGB) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (pixels_per_metre > 0) png_set_pHYs(png, info, pixels_per_metre, pixels_per_metre, PNG_RESOLUTION_METER);
  if (text_count > 0) png_set_text(png, info, texts, text_count);
  png_write_info(png, info);
  for (int y = 0; y < pixels.height; ++y) png_write_row(png, pixels.bytes + pixels.row_bytes * std::size_t(y));
  png_write_end(png, info);
  return true;
}

bool is_ascii(std::string_view text) {
  for (char c : text)
    if (static_cast<unsigned char>(c) >= 0x80) return false;
  return true;
}

// The texts stay owned by `metadata`. Plain tEXt holds Latin-1, so anything else goes into an iTXt chunk (UTF-8).
std::vector<png_text> make_texts(const Metadata& metadata) {
  std::vector<png_text> texts;
  for (const auto& [name, value] : metadata) {
    png_text text{};
    text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(name.c_str());
    text.text = const_cast<char*>(value.c_str());
    text.text_length = text.compression == PNG_TEXT_COMPRESSION_NONE ? value.size() : 0;
    text.itxt_length = text.compression == PNG_TEXT_COMPRESSION_NONE ? 0 : value.size();
    texts.push_back(text);
  }
  return texts;
}

Result<std::string> encode(const Pixels& pixels, const Metadata& metadata, double pixels_per_inch) {
  Output output;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, shabon_png_error, shabon_png_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool written = false;
  if (info) {
    std::vector<png_text> texts = make_texts(metadata);
    png_set_write_fn(png, &output, shabon_png_write, shabon_png_flush);
    const double per_metre = std::clamp(pixels_per_inch / metres_per_inch, 0.0, 1e9);
    written = write_image(png, info, pixels, texts.data(), static_cast<int>(texts.size()),
                          static_cast<png_uint_32>(std::lround(per_metre)));
  }
  png_destroy_write_struct(&png, &info);
  if (!written) return fail(Failure::internal, "writing PNG: " + output.message);
  return std::move(output.bytes);
}

}  // namespace

Result<std::string> encode_png(int width, int height, std::span<const std::uint8_t> rgb, const Metadata& metadata,
                               double pixels_per_inch) try {
  if (auto error = refuse_contents(width, height, rgb.size(), metadata)) return *error;
  return encode({width, height, 8, PNG_COLOR_TYPE_RGB, rgb.data(), 3 * static_cast<std::size_t>(width)}, metadata,
                pixels_per_inch);
} catch (const std::bad_alloc&) {
  return fail(Failure::internal, "writing PNG: not enough memory");
}

Result<std::string> encode_png16(int width, int height, std::span<const std::uint16_t> grey,
                                 const Metadata& metadata) try {
  if (auto error = refuse_contents(width, height, 3 * grey.size(), metadata)) return *error;
  std::vector<std::uint8_t> bytes;  // the file has the upper byte first
  bytes.reserve(2 * grey.size());
  for (const std::uint16_t value : grey) {
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
  }
  return encode({width, height, 16, PNG_COLOR_TYPE_GRAY, bytes.data(), 2 * static_cast<std::size_t>(width)}, metadata,
                0);
} catch (const std::bad_alloc&) {
  return fail(Failure::internal, "writing PNG: not enough memory");
}

Status write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgb,
                 const Metadata& metadata, double pixels_per_inch) {
  const Result<std::string> bytes = encode_png(width, height, rgb, metadata, pixels_per_inch);
  if (!bytes) {
    Diagnostics errors = bytes.errors();
    for (Diagnostic& error : errors) error.source = path.string();
    return errors;
  }
  return write_file_atomically(path, *bytes);
}

Result<Rgb8Image> decode_png(std::string_view bytes, const std::string& source) try {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto give_up = [&](const std::string& message) {
    png_image_free(&image);
    return picture_error(source, message);
  };
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
    return give_up(std::string("damaged or truncated PNG: ") + image.message);
  if (auto error = refuse_size(source, image.width, image.height)) {
    png_image_free(&image);
    return *error;
  }
  if (!png_is_whole(bytes, std::uint64_t{image.width} * image.height)) return give_up("truncated PNG");
  image.format = PNG_FORMAT_RGB;
  Rgb8Image result{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  result.rgb.resize(PNG_IMAGE_SIZE(image));
  const png_color black{0, 0, 0};
  if (!png_image_finish_read(&image, &black, result.rgb.data(), 0, nullptr))
    return give_up(std::string("damaged or truncated PNG: ") + image.message);
  return result;
} catch (const std::bad_alloc&) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
}

Result<Rgb8Image> read_png(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, picture_max_bytes);
  if (!bytes) return bytes.errors();
  return decode_png(*bytes, path.string());
}

}  // namespace shabon::io
