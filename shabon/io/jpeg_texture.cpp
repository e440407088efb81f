// JPEG as the numbers in it, through libjpeg.
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include <jpeglib.h>

#include <jerror.h>

#include "shabon/io/pixel_sink.h"
#include "shabon/io/texture_image.h"

namespace shabon::io {

namespace {

// Progressive pictures refine each other scan by scan: no program writes so many, and each costs a whole picture's
// time.
constexpr int most_scans = 500;

// libjpeg reports errors through here; between setjmp and them there must be nothing with a destructor.
struct Errors {
  jpeg_error_mgr manager;  // first: libjpeg knows this part only
  std::jmp_buf back;
  std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void leave(j_common_ptr common) {
  auto* errors = reinterpret_cast<Errors*>(common->err);
  errors->manager.format_message(common, errors->message.data());
  std::longjmp(errors->back, 1);
}

extern "C" void shabon_jpeg_error(j_common_ptr common) { leave(common); }

// Of what libjpeg only warns of: pixels that are not there would be made up.
extern "C" void shabon_jpeg_warning(j_common_ptr common, int level) {
  if (level >= 0) return;
  const int code = common->err->msg_code;
  for (const int damage : {JWRN_JPEG_EOF, JWRN_HIT_MARKER, JWRN_HUFF_BAD_CODE, JWRN_ARITH_BAD_CODE, JWRN_MUST_RESYNC})
    if (code == damage) leave(common);
}

extern "C" void shabon_jpeg_progress(j_common_ptr common) {
  auto* jpeg = reinterpret_cast<j_decompress_ptr>(common);
  if (jpeg->input_scan_number <= most_scans) return;
  auto* errors = reinterpret_cast<Errors*>(common->err);
  std::snprintf(errors->message.data(), errors->message.size(), "it has more than %d scans", most_scans);
  std::longjmp(errors->back, 1);
}

// The reader and its memory.
struct Reader {
  Reader() {
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = shabon_jpeg_error;
    errors.manager.emit_message = shabon_jpeg_warning;
    if (setjmp(errors.back)) throw std::bad_alloc();
    jpeg_create_decompress(&jpeg);
    progress.progress_monitor = shabon_jpeg_progress;
    jpeg.progress = &progress;
  }
  ~Reader() { jpeg_destroy_decompress(&jpeg); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  Errors errors;
  jpeg_progress_mgr progress{};
  jpeg_decompress_struct jpeg{};
};

bool read_header(Reader& reader, std::string_view bytes) {
  if (setjmp(reader.errors.back)) return false;
  jpeg_mem_src(&reader.jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&reader.jpeg, TRUE);
  return true;
}

// Grey or R, G, B of 8 bits.
bool read_rows(Reader& reader, std::uint8_t* pixels) {
  if (setjmp(reader.errors.back)) return false;
  jpeg_decompress_struct& jpeg = reader.jpeg;
  jpeg.out_color_space = jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_start_decompress(&jpeg);
  const std::size_t row = std::size_t{jpeg.output_width} * static_cast<std::size_t>(jpeg.output_components);
  while (jpeg.output_scanline < jpeg.output_height) {
    std::uint8_t* at = pixels + row * jpeg.output_scanline;
    jpeg_read_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

Result<TextureImage> decode_jpeg_texture(std::string_view bytes, const std::string& source) try {
  Reader reader;
  const auto damaged = [&] {
    return picture_error(source, std::string("damaged or truncated JPEG: ") + reader.errors.message.data());
  };
  if (!read_header(reader, bytes)) return damaged();
  const jpeg_decompress_struct& jpeg = reader.jpeg;
  if (auto error = refuse_size(source, jpeg.image_width, jpeg.image_height)) return *error;
  if (jpeg.num_components != 1 && jpeg.num_components != 3)
    return picture_error(source, "expected a JPEG of grey or of red, green and blue, got one of " +
                                     std::to_string(jpeg.num_components) + " components, as for printing");
  TextureImage image;
  image.width = static_cast<int>(jpeg.image_width), image.height = static_cast<int>(jpeg.image_height);
  image.channels = jpeg.num_components;
  image.whole_numbers = true;
  image.bits = 8;
  std::vector<std::uint8_t> pixels(std::size_t{jpeg.image_width} * jpeg.image_height *
                                   static_cast<std::size_t>(image.channels));
  if (!read_rows(reader, pixels.data())) return damaged();
  constexpr float largest = 255;
  image.values.reserve(pixels.size());
  for (const std::uint8_t value : pixels) image.values.push_back(static_cast<float>(value) / largest);
  return image;
} catch (const std::bad_alloc&) {
  return picture_error(source, "not enough memory for this picture", Failure::file);
}

}  // namespace shabon::io
