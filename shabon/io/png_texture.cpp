// PNG as the numbers in it, through libpng's full interface.
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "shabon/io/pixel_sink.h"
#include "shabon/io/png_limits.h"
#include "shabon/io/texture_image.h"

namespace shabon::io {

namespace {

// libpng reports errors by longjmp: between setjmp and it there must be nothing with a destructor.
struct Input {
  const char* bytes;
  std::size_t size, at = 0;
  std::array<char, 160> message{};
};

extern "C" void shabon_png_read_error(png_structp png, png_const_charp message) {
  auto& text = static_cast<Input*>(png_get_error_ptr(png))->message;
  std::strncpy(text.data(), message, text.size() - 1);
  png_longjmp(png, 1);
}

extern "C" void shabon_png_read_warning(png_structp, png_const_charp) {}

extern "C" void shabon_png_read(png_structp png, png_bytep to, png_size_t count) {
  auto& input = *static_cast<Input*>(png_get_io_ptr(png));
  if (count > input.size - input.at) png_error(png, "the file ends early");
  std::memcpy(to, input.bytes + input.at, count);
  input.at += count;
}

struct Shape {
  png_uint_32 width = 0, height = 0;
  int bits = 0, channels = 0;
  std::size_t row_bytes = 0;
};

// Up to the pixels; what they will be: 8 or 16 bits (in this machine's order of bytes), one channel or three.
bool read_shape(png_structp png, png_infop info, Shape* shape) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_user_limits(png, image_max_side, image_max_side);
  png_read_info(png, info);
  shape->width = png_get_image_width(png, info);
  shape->height = png_get_image_height(png, info);
  shape->bits = png_get_bit_depth(png, info);
  const int kind = png_get_color_type(png, info);
  if (kind == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
  if (kind == PNG_COLOR_TYPE_PALETTE) shape->bits = 8;
  if (kind == PNG_COLOR_TYPE_GRAY && shape->bits < 8) png_set_expand_gray_1_2_4_to_8(png);
  png_set_strip_alpha(png);
  if (shape->bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  shape->channels = png_get_channels(png, info);
  shape->row_bytes = png_get_rowbytes(png, info);
  return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

std::vector<float> numbers_of(const std::vector<std::uint8_t>& bytes, bool wide) {
  constexpr float largest_byte = 255, largest_word = 65535;
  std::vector<float> values(wide ? bytes.size() / 2 : bytes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint16_t word = bytes[wide ? 2 * i : i];
    if (wide) std::memcpy(&word, &bytes[2 * i], sizeof word);
    values[i] = static_cast<float>(word) / (wide ? largest_word : largest_byte);
  }
  return values;
}

// The reader and its memory.
struct Reader {
  Reader(std::string_view bytes)
      : input{bytes.data(), bytes.size()},
        png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, shabon_png_read_error, shabon_png_read_warning)),
        info(png ? png_create_info_struct(png) : nullptr) {
    if (info == nullptr) throw std::bad_alloc();
    png_set_read_fn(png, &input, shabon_png_read);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Input input;
  png_structp png;
  png_infop info;
};

}  // namespace

Result<TextureImage> decode_png_texture(std::string_view bytes, const std::string& source) try {
  Reader reader(bytes);
  const auto damaged = [&] {
    return picture_error(source, std::string("damaged or truncated PNG: ") + reader.input.message.data());
  };
  Shape shape;
  if (!read_shape(reader.png, reader.info, &shape)) return damaged();
  if (auto error = refuse_size(source, shape.width, shape.height)) return *error;
  if (!png_is_whole(bytes, std::uint64_t{shape.width} * shape.height)) return picture_error(source, "truncated PNG");
  std::vector<std::uint8_t> pixels(shape.row_bytes * shape.height);
  std::vector<png_bytep> rows;
  for (std::size_t row = 0; row < shape.height; ++row) rows.push_back(pixels.data() + row * shape.row_bytes);
  if (!read_rows(reader.png, rows.data())) return damaged();
  TextureImage image{static_cast<int>(shape.width), static_cast<int>(shape.height), shape.channels,
                     numbers_of(pixels, shape.bits == 16)};
  image.whole_numbers = true;
  image.bits = shape.bits;
  return image;
} catch (const std::bad_alloc&) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
}

}  // namespace shabon::io
