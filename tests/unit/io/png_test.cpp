#include <gtest/gtest.h>

#include "scratch.h"
#include "shabon/io/image.h"

namespace shabon::io {
namespace {

std::vector<std::uint8_t> test_pixels(int width, int height) {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < 3 * width * height; ++i) rgb.push_back(static_cast<std::uint8_t>(i * 7));
  return rgb;
}

TEST(Png, WritesWhatItReads) {
  const Scratch scratch;
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {101, 57}}) {
    const auto rgb = test_pixels(width, height);
    ASSERT_TRUE(write_png(scratch / "a.png", width, height, rgb, {}));
    const auto read = read_png(scratch / "a.png");
    ASSERT_TRUE(read) << errors_of(read);
    EXPECT_EQ(read->width, width);
    EXPECT_EQ(read->height, height);
    EXPECT_EQ(read->rgb, rgb);
  }
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(Png, CarriesColourSpaceAndMetadata) {
  const auto bytes = encode_png(3, 2, test_pixels(3, 2), {{"Software", "shabon"}, {"Scene", "しゃぼん"}});
  ASSERT_TRUE(bytes);
  const std::string srgb("\0\0\0\1sRGB\0", 9);
  EXPECT_NE(bytes->find(srgb), std::string::npos);
  EXPECT_NE(bytes->find(std::string("tEXtSoftware\0shabon", 19)), std::string::npos);
  EXPECT_NE(bytes->find("iTXtScene"), std::string::npos);
  EXPECT_NE(bytes->find("しゃぼん"), std::string::npos);
}

TEST(Png, SaysHowLargeToPrint) {
  const std::string per_metre("pHYs\0\0\x2e\x23\0\0\x2e\x23\1", 13);  // 300 per inch are 11811 per metre
  EXPECT_NE(encode_png(3, 2, test_pixels(3, 2), {}, 300)->find(per_metre), std::string::npos);
  EXPECT_EQ(encode_png(3, 2, test_pixels(3, 2), {})->find("pHYs"), std::string::npos);
}

TEST(Png, EveryPrefixIsTruncated) {
  const std::string whole = *encode_png(11, 9, test_pixels(11, 9), {{"a", "b"}});
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_TRUE(fails(decode_png(std::string_view(whole).substr(0, length), "t"), Failure::content, "")) << length;
}

TEST(Png, SurvivesFlippedBits) {
  const std::string whole = *encode_png(5, 3, test_pixels(5, 3), {});
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
    EXPECT_TRUE(is_whole_or_refused(decode_png(flipped, "t"))) << bit;
  }
}

TEST(Png, WriterRefusesWhatDoesNotFit) {
  const Scratch scratch;
  const auto rgb = test_pixels(3, 2);
  EXPECT_TRUE(fails(write_png(scratch / "none/a.png", 3, 2, rgb, {}), Failure::file, "No such file"));
  EXPECT_TRUE(fails(write_png(scratch.folder(), 3, 2, rgb, {}), Failure::file, "folder"));
  EXPECT_TRUE(fails(write_png("/dev/full", 3, 2, rgb, {}), Failure::file, "No space left"));
  EXPECT_TRUE(fails(encode_png(3, 3, rgb, {}), Failure::internal, "do not fit"));
  EXPECT_TRUE(fails(encode_png(0, 0, {}, {}), Failure::internal, "without pixels"));
  for (const std::string& name : {std::string(), std::string(80, 'n'), std::string("a\nb"), std::string(" a")})
    EXPECT_TRUE(fails(encode_png(3, 2, rgb, {{name, "x"}}), Failure::internal, "metadata name"));
  EXPECT_EQ(scratch.entries(), 0u);
}

}  // namespace
}  // namespace shabon::io
