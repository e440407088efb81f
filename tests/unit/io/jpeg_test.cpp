// JPEG as numbers: pictures made here, with libjpeg's own writer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

#include "scratch.h"
#include "shabon/io/texture_image.h"

namespace shabon::io {
namespace {

struct Kind {
  int channels;
  J_COLOR_SPACE colors;
  bool progressive;
};

constexpr Kind kinds[] = {
    {1, JCS_GRAYSCALE, false}, {1, JCS_GRAYSCALE, true}, {3, JCS_RGB, false}, {3, JCS_RGB, true}, {4, JCS_CMYK, false}};

// Slow slopes, of which the best quality loses next to nothing.
int sample_at(int x, int y, int c) { return 40 + 5 * x + 3 * y + 20 * c; }

std::string jpeg_of(const Kind& kind, int width, int height) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width), jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = kind.channels, jpeg.in_color_space = kind.colors;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  if (kind.progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < height; ++y) {
    std::vector<unsigned char> row;
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < kind.channels; ++c) row.push_back(static_cast<unsigned char>(sample_at(x, y, c)));
    unsigned char* at = row.data();
    jpeg_write_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string result(reinterpret_cast<const char*>(bytes), size);
  std::free(bytes);
  return result;
}

TEST(JpegTexture, KeepsTheNumbersOfEveryKind) {
  for (const Kind& kind : kinds) {
    if (kind.channels == 4) continue;
    const auto image = decode_jpeg_texture(jpeg_of(kind, 19, 13), "t");
    ASSERT_TRUE(image) << errors_of(image);
    EXPECT_EQ(image->width, 19);
    EXPECT_EQ(image->height, 13);
    EXPECT_EQ(image->channels, kind.channels);
    EXPECT_EQ(image->bits, 8);
    EXPECT_TRUE(image->whole_numbers);
    std::size_t at = 0;
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 19; ++x)
        for (int c = 0; c < kind.channels; ++c)
          ASSERT_NEAR(image->values[at++] * 255, sample_at(x, y, c), 2.5) << x << " " << y << " " << c;
  }
}

TEST(JpegTexture, PicturesOfInksAreRefused) {
  EXPECT_TRUE(fails(decode_jpeg_texture(jpeg_of(kinds[4], 3, 3), "t"), Failure::content,
                    "expected a JPEG of grey or of red, green and blue, got one of 4 components"));
}

TEST(JpegTexture, EveryPrefixIsTruncated) {
  for (const Kind& kind : kinds) {
    const std::string whole = jpeg_of(kind, 19, 13);
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_TRUE(fails(decode_jpeg_texture(std::string_view(whole).substr(0, length), "t"), Failure::content, "JPEG"))
          << length;
  }
}

TEST(JpegTexture, SurvivesFlippedBits) {
  for (const Kind& kind : kinds) {
    const std::string whole = jpeg_of(kind, 9, 5);
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      const auto image = decode_jpeg_texture(flipped, "t");
      if (!image) continue;
      const auto values = static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) *
                          static_cast<std::size_t>(image->channels);
      EXPECT_EQ(image->values.size(), values) << bit;
    }
  }
}

// A header that tells of 60000 x 60000 pixels, more than any picture may have.
TEST(JpegTexture, SizesAreCheckedBeforeTheyAreBelieved) {
  std::string bytes = jpeg_of(kinds[2], 9, 5);
  const std::size_t frame = bytes.find(std::string("\xFF\xC0", 2));
  ASSERT_NE(frame, std::string::npos);
  bytes.replace(frame + 5, 4, "\xEA\x60\xEA\x60");
  EXPECT_TRUE(fails(decode_jpeg_texture(bytes, "t"), Failure::content, "60000x60000"));
}

TEST(JpegTexture, IsToldApartByContent) {
  const Scratch scratch;
  const auto image = read_texture_image(scratch.put("a.png", jpeg_of(kinds[0], 4, 4)));
  ASSERT_TRUE(image) << errors_of(image);
  EXPECT_EQ(image->channels, 1);
}

}  // namespace
}  // namespace shabon::io
