#include <gtest/gtest.h>

#include <cmath>

#include "scratch.h"
#include "shabon/io/image.h"

namespace shabon::io {
namespace {

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (int value : values) bytes += static_cast<char>(value);
  return bytes;
}

const std::string magic = "#?RADIANCE\n", format = "FORMAT=32-bit_rle_rgbe\n";

std::string header(int width, int height, const std::string& variables = format) {
  return magic + variables + "\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

// Pixel (x, y) = (x + 1, y + 1, 128) times 2^-8 at exponent 128, that is x+1, y+1, 128 in units of 1/256.
std::string flat_pixel(int x, int y) { return bytes_of({x + 1, y + 1, 128, 128}); }

std::string flat_picture(int width, int height) {
  std::string bytes = header(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) bytes += flat_pixel(x, y);
  return bytes;
}

// The same picture run length coded: components of a row one after the other, red literally, the others as runs.
std::string coded_picture(int width, int height) {
  std::string bytes = header(width, height);
  for (int y = 0; y < height; ++y) {
    bytes += bytes_of({2, 2, width >> 8, width & 255, width});
    for (int x = 0; x < width; ++x) bytes += bytes_of({x + 1});
    for (int value : {y + 1, 128, 128}) bytes += bytes_of({128 + width - 3, value, 3, value, value, value});
  }
  return bytes;
}

void expect_test_picture(const Result<RgbImage>& image, int width, int height) {
  ASSERT_TRUE(image) << errors_of(image);
  ASSERT_EQ(image->width, width);
  ASSERT_EQ(image->height, height);
  ASSERT_EQ(image->rgb.size(), static_cast<std::size_t>(3 * width * height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float* pixel = &image->rgb[static_cast<std::size_t>(3 * (y * width + x))];
      EXPECT_EQ(pixel[0], static_cast<float>(x + 1) / 256);
      EXPECT_EQ(pixel[1], static_cast<float>(y + 1) / 256);
      EXPECT_EQ(pixel[2], 0.5f);
    }
}

TEST(Hdr, ReadsFlatRows) { expect_test_picture(decode_hdr(flat_picture(5, 3), "t"), 5, 3); }
TEST(Hdr, ReadsCodedRows) { expect_test_picture(decode_hdr(coded_picture(20, 3), "t"), 20, 3); }

TEST(Hdr, ReadsOldRuns) {
  const std::string a = bytes_of({10, 20, 30, 129}), b = bytes_of({40, 50, 60, 128});
  const auto image = decode_hdr(header(5, 1) + a + bytes_of({1, 1, 1, 3}) + b, "t");
  ASSERT_TRUE(image) << errors_of(image);
  for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(image->rgb[3 * x], 20.0f / 256);
  EXPECT_EQ(image->rgb[12], 40.0f / 256);
  // Two repeats in sequence: 2 + 1 * 256 pixels more.
  const auto wide = decode_hdr(header(259, 1) + a + bytes_of({1, 1, 1, 2, 1, 1, 1, 1}), "t");
  ASSERT_TRUE(wide) << errors_of(wide);
  EXPECT_EQ(wide->rgb[3 * 258 + 2], 60.0f / 256);
}

TEST(Hdr, AnExponentOfZeroIsBlack) {
  const auto image = decode_hdr(header(1, 1) + bytes_of({9, 9, 9, 0}), "t");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->rgb, (std::vector<float>{0, 0, 0}));
}

TEST(Hdr, DividesExposureOut) {
  const std::string lines = format + "# a comment\nSOFTWARE=x\nEXPOSURE= 2\nEXPOSURE=0.25\nCOLORCORR= 1 2 4\n";
  const auto image = decode_hdr(header(1, 1, lines) + bytes_of({128, 128, 128, 128}), "t");
  ASSERT_TRUE(image) << errors_of(image);
  EXPECT_EQ(image->rgb, (std::vector<float>{1.0f, 0.5f, 0.25f}));
}

TEST(Hdr, ReadsHeadersWithCarriageReturns) {
  const auto image = decode_hdr("#?RGBE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" + flat_pixel(0, 0), "t");
  expect_test_picture(image, 1, 1);
}

TEST(Hdr, RefusesWithAReason) {
  const std::string pixel = flat_pixel(0, 0);
  const auto refused = [](const std::string& bytes, const std::string& words) {
    return fails(decode_hdr(bytes, "t"), Failure::content, words);
  };
  EXPECT_TRUE(refused("", "must begin with '#?'"));
  EXPECT_TRUE(refused("hello\n", "must begin with '#?'"));
  EXPECT_TRUE(refused(magic + format, "header is truncated"));
  EXPECT_TRUE(refused(magic + format + "\n-Y 1 +X 1", "header is truncated"));
  EXPECT_TRUE(refused(magic + std::string(100000, 'x'), "header is truncated"));
  EXPECT_TRUE(refused(header(1, 1, "FORMAT=32-bit_rle_xyze\n") + pixel, "FORMAT=32-bit_rle_xyze are not supported"));
  for (const char* value : {"0", "-1", "x", "nan", "", "1 2"})
    EXPECT_TRUE(
        refused(header(1, 1, "EXPOSURE=" + std::string(value) + "\n") + pixel, "EXPOSURE: expected one number"));
  EXPECT_TRUE(refused(header(1, 1, "COLORCORR=1 2\n") + pixel, "COLORCORR: expected three numbers"));
  for (const char* turned : {"+Y 1 +X 1", "-Y 1 -X 1", "+X 1 -Y 1"})
    EXPECT_TRUE(refused(magic + "\n" + turned + "\n" + pixel, "is not supported; expected '-Y +X'"));
  for (const char* broken : {"-Y 1", "-Y a +X 1", "-Y 1 +X 1 1", "-Y -1 +X 1", "-Y 99999999999 +X 1", "x"})
    EXPECT_TRUE(refused(magic + "\n" + broken + "\n" + pixel, "expected a resolution line"));
  EXPECT_TRUE(refused(header(0, 1), "without pixels"));
  EXPECT_TRUE(refused(header(65537, 1), "too large"));
  EXPECT_TRUE(refused(header(65536, 65536), "too large"));
  EXPECT_TRUE(refused(header(2, 1) + bytes_of({1, 1, 1, 2}), "damaged in row 0 of 1"));     // repeats nothing
  EXPECT_TRUE(refused(header(2, 1) + pixel + bytes_of({1, 1, 1, 2}), "damaged in row 0"));  // run past the row
  EXPECT_TRUE(refused(header(8, 1) + bytes_of({2, 2, 0, 9}), "damaged in row 0"));          // another width
  EXPECT_TRUE(refused(header(8, 1) + bytes_of({2, 2, 0, 8, 128 + 9, 1}), "damaged in row 0"));
  EXPECT_TRUE(refused(header(8, 1) + bytes_of({2, 2, 0, 8, 0, 1}), "damaged in row 0"));
  EXPECT_TRUE(refused(header(1, 1, "EXPOSURE=1e-300\n") + bytes_of({1, 1, 2, 255}), "infinite"));
}

TEST(Hdr, EveryPrefixIsTruncated) {
  for (const std::string& whole : {flat_picture(9, 4), coded_picture(20, 4)})
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_TRUE(fails(decode_hdr(whole.substr(0, length), "t"), Failure::content, "")) << length;
}

TEST(Hdr, SurvivesFlippedBits) {
  for (const std::string& whole : {flat_picture(9, 2), coded_picture(20, 2)})
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      EXPECT_TRUE(is_whole_or_refused(decode_hdr(flipped, "t"))) << bit;
    }
}

TEST(Hdr, ALyingHeaderCostsNothing) {
  EXPECT_TRUE(fails(decode_hdr(header(16384, 16384) + flat_pixel(0, 0), "t"), Failure::content, "truncated in row 0"));
}

TEST(Picture, IsToldApartByContent) {
  const Scratch scratch;
  expect_test_picture(read_image(scratch.put("a.exr", flat_picture(5, 3))), 5, 3);
  expect_test_picture(read_hdr(scratch.put("a.hdr", flat_picture(5, 3))), 5, 3);
  const auto refused = [&](const std::string& bytes, const std::string& words) {
    return fails(read_image(scratch.put("x", bytes)), Failure::content, words);
  };
  EXPECT_TRUE(refused("", "got an empty file"));
  EXPECT_TRUE(refused("\x89PNG\r\n", "got PNG"));
  EXPECT_TRUE(refused("\xFF\xD8\xFF", "got JPEG"));
  EXPECT_TRUE(refused("some text", "expected a picture in OpenEXR (.exr) or Radiance (.hdr), got something else"));
  EXPECT_TRUE(fails(read_image(scratch / "none"), Failure::file, "No such file"));
  EXPECT_TRUE(fails(read_image(scratch.folder()), Failure::file, "folder"));
  EXPECT_TRUE(fails(read_hdr(scratch / "none"), Failure::file, "No such file"));
}

}  // namespace
}  // namespace shabon::io
