#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "scratch.h"
#include "shabon/io/image.h"

namespace shabon::io {
namespace {

namespace fs = std::filesystem;
constexpr float infinity = std::numeric_limits<float>::infinity();

RgbImage test_image(int width, int height) {
  RgbImage image{width, height, {}, 0};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<float>(i) * 0.25f);
  return image;
}

// Writes `image` with a header of the test's own making, at the data window's corner.
fs::path put(const Scratch& scratch, Imf::Header header, RgbImage image, Imf::PixelType type = Imf::FLOAT,
             const std::string& names = "RGB") {
  const fs::path path = scratch / "test.exr";
  for (char name : names) header.channels().insert(std::string(1, name), Imf::Channel(type));
  const Imath::Box2i window = header.dataWindow();
  const std::size_t xs = 3 * sizeof(float), ys = xs * static_cast<std::size_t>(image.width);
  std::vector<half> halves(image.rgb.begin(), image.rgb.end());
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Imath::V2i size = window.size() + Imath::V2i(1, 1);
    char* base =
        type == Imf::HALF ? reinterpret_cast<char*>(halves.data() + i) : reinterpret_cast<char*>(image.rgb.data() + i);
    const std::size_t part = type == Imf::HALF ? 2 : 1;
    buffer.insert(std::string(1, names[i]),
                  Imf::Slice::Make(type, base, window.min, size.x, size.y, xs / part, ys / part));
  }
  if (header.hasTileDescription()) {
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
  }
  return path;
}

TEST(Exr, WritesWhatItReads) {
  const Scratch scratch;
  RgbImage image = test_image(37, 70);
  image.rgb[5] = 1e-30f;
  image.rgb[6] = 3e38f;
  ASSERT_TRUE(write_exr(scratch / "a.exr", image, {{"scene", "bubble \xC3\xA9"}, {"seed", "1"}}));
  const auto read = read_image(scratch / "a.exr");
  ASSERT_TRUE(read) << errors_of(read);
  EXPECT_EQ(read->width, 37);
  EXPECT_EQ(read->height, 70);
  EXPECT_EQ(read->rgb, image.rgb);
  EXPECT_EQ(read->negatives, 0);
  Imf::InputFile file((scratch / "a.exr").c_str());
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("scene").value(), "bubble \xC3\xA9");
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("seed").value(), "1");
  EXPECT_NEAR(Imf::chromaticities(file.header()).green.y, 0.60f, 1e-7);
  EXPECT_NEAR(Imf::chromaticities(file.header()).white.x, 0.3127f, 1e-7);
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(Exr, ReadsEveryCompressionHalfAndFloat) {
  const Scratch scratch;
  const RgbImage image = test_image(20, 20);
  for (Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION})
    for (Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
      Imf::Header header(20, 20);
      header.compression() = compression;
      const auto read = read_exr(put(scratch, header, image, type));
      ASSERT_TRUE(read) << errors_of(read);
      EXPECT_EQ(read->rgb, image.rgb);  // multiples of 1/4 up to 300 are exact halves
    }
}

TEST(Exr, ReadsTiles) {
  const Scratch scratch;
  const RgbImage image = test_image(50, 150);
  Imf::Header header(50, 150);
  header.setTileDescription(Imf::TileDescription(16, 48, Imf::ONE_LEVEL));
  const auto read = read_exr(put(scratch, header, image));
  ASSERT_TRUE(read) << errors_of(read);
  EXPECT_EQ(read->rgb, image.rgb);
}

// The picture is the display window: cut where the data reach past it, black where they do not.
TEST(Exr, PlacesTheDataWindow) {
  const Scratch scratch;
  const Imath::Box2i display({10, 20}, {19, 119});  // 10 x 100
  for (const Imath::Box2i& data : {Imath::Box2i({12, 25}, {15, 30}), Imath::Box2i({0, 0}, {14, 200}),
                                   Imath::Box2i({15, 100}, {30, 130}), Imath::Box2i({-5, 119}, {10, 119})}) {
    const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
    const RgbImage image = test_image(width, height);
    const auto read = read_exr(put(scratch, Imf::Header(display, data), image));
    ASSERT_TRUE(read) << errors_of(read);
    ASSERT_EQ(read->width, 10);
    ASSERT_EQ(read->height, 100);
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 10; ++x) {
        const int dx = x + 10 - data.min.x, dy = y + 20 - data.min.y;
        const bool inside = dx >= 0 && dy >= 0 && dx < width && dy < height;
        const float expected = inside ? image.rgb[static_cast<std::size_t>(3 * (dy * width + dx) + 1)] : 0;
        ASSERT_EQ(read->rgb[static_cast<std::size_t>(3 * (y * 10 + x) + 1)], expected) << x << " " << y;
      }
  }
  const Imath::Box2i elsewhere({100, 0}, {109, 9});
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(display, elsewhere), test_image(10, 10))), Failure::content,
                    "outside the display window"));
}

TEST(Exr, HonoursChromaticities) {
  const Scratch scratch;
  const RgbImage image{3, 1, {1, 1, 1, 0.5f, 0.25f, 0.125f, 1, 0, 0}, 0};
  Imf::Header header(3, 1);
  // ITU-R BT.2020 with D65: white stays white; the matrix to BT.709 is in ITU-R BT.2407-0, section 2.
  Imf::addChromaticities(header, {{0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}});
  const auto read = read_exr(put(scratch, header, image));
  ASSERT_TRUE(read) << errors_of(read);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(read->rgb[i], 1, 1e-6);
  EXPECT_NEAR(read->rgb[3], 1.6605 * 0.5 - 0.5876 * 0.25 - 0.0728 * 0.125, 1e-4);
  EXPECT_NEAR(read->rgb[4], -0.1246 * 0.5 + 1.1329 * 0.25 - 0.0083 * 0.125, 1e-4);
  EXPECT_NEAR(read->rgb[5], -0.0182 * 0.5 - 0.1006 * 0.25 + 1.1187 * 0.125, 1e-4);
  EXPECT_NEAR(read->rgb[6], 1.6605, 1e-4);  // BT.2020's red lies outside sRGB:
  EXPECT_EQ(read->rgb[7], 0);               // its negative green and blue become 0
  EXPECT_EQ(read->negatives, 2);
}

TEST(Exr, KeepsTheColourOfAnotherWhite) {
  const Scratch scratch;
  Imf::Header header(1, 1);
  // ACES AP0 with its white near D60 (SMPTE ST 2065-1). Its white has Y = 1 and is redder than D65.
  Imf::addChromaticities(header, {{0.7347f, 0.2653f}, {0.0f, 1.0f}, {0.0001f, -0.0770f}, {0.32168f, 0.33767f}});
  const auto read = read_exr(put(scratch, header, {1, 1, {1, 1, 1}, 0}));
  ASSERT_TRUE(read) << errors_of(read);
  EXPECT_NEAR(0.2126 * read->rgb[0] + 0.7152 * read->rgb[1] + 0.0722 * read->rgb[2], 1, 1e-4);
  EXPECT_GT(read->rgb[0], 1.03);
  EXPECT_LT(read->rgb[2], 0.93);
}

TEST(Exr, SrgbChromaticitiesChangeNoBit) {
  const Scratch scratch;
  Imf::Header header(20, 20);
  Imf::addChromaticities(header, Imf::Chromaticities());
  EXPECT_EQ(read_exr(put(scratch, header, test_image(20, 20)))->rgb, test_image(20, 20).rgb);
}

TEST(Exr, RefusesImpossibleChromaticities) {
  const Scratch scratch;
  const Imath::V2f a(0.3f, 0.3f), b(0.6f, 0.3f), c(0.1f, 0.7f), zero(0, 0), nan(NAN, 0.3f);
  for (const Imf::Chromaticities& bad : {Imf::Chromaticities(a, a, a, a), Imf::Chromaticities(b, c, zero, zero),
                                         Imf::Chromaticities(nan, b, c, a), Imf::Chromaticities(b, c, a, nan)}) {
    Imf::Header header(1, 1);
    Imf::addChromaticities(header, bad);
    EXPECT_TRUE(fails(read_exr(put(scratch, header, test_image(1, 1))), Failure::content, "no colour space"));
  }
}

TEST(Exr, NamesTheBadPixelAndCountsNegatives) {
  const Scratch scratch;
  RgbImage image = test_image(5, 4);
  image.rgb[2] = -1;
  image.rgb[7] = -2;
  image.rgb[8] = -0.0f;
  const auto read = read_exr(put(scratch, Imf::Header(5, 4), image));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->negatives, 2);
  EXPECT_EQ(read->rgb[2], 0);
  EXPECT_FALSE(std::signbit(read->rgb[8]));
  image.rgb[3 * (2 * 5 + 3) + 1] = NAN;
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(5, 4), image)), Failure::content,
                    "pixel (3, 2), counted from the top left, is not a number in G"));
  image.rgb[3 * 5 + 2] = -infinity;
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(5, 4), image)), Failure::content, "pixel (0, 1)"));
  image.rgb[0] = 70000;  // becomes infinite as a half
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(5, 4), image, Imf::HALF)), Failure::content, "infinite in R"));
}

TEST(Exr, NamesTheChannelsItFound) {
  const Scratch scratch;
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(3, 3), test_image(3, 3), Imf::FLOAT, "YA")), Failure::content,
                    "missing: R, G, B; found: A, Y"));
  EXPECT_TRUE(fails(read_exr(put(scratch, Imf::Header(3, 3), test_image(3, 3), Imf::FLOAT, "RG")), Failure::content,
                    "missing: B; found: G, R"));
}

TEST(Exr, EveryPrefixIsTruncated) {
  const Scratch scratch;
  Imf::Header tiled(9, 7), lines(9, 7);
  tiled.setTileDescription(Imf::TileDescription(4, 4, Imf::ONE_LEVEL));
  lines.compression() = Imf::PIZ_COMPRESSION;
  for (const Imf::Header& header : {tiled, lines}) {
    put(scratch, header, test_image(9, 7), Imf::HALF);
    const std::string whole = scratch.get("test.exr");
    ASSERT_TRUE(decode_exr(whole, "t"));
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_TRUE(fails(decode_exr(std::string_view(whole).substr(0, length), "t"), Failure::content, "")) << length;
  }
}

TEST(Exr, SurvivesFlippedBits) {
  const Scratch scratch;
  Imf::Header tiled(9, 7), lines(9, 7);
  tiled.setTileDescription(Imf::TileDescription(4, 4, Imf::ONE_LEVEL));
  for (const Imf::Header& header : {tiled, lines}) {
    put(scratch, header, test_image(9, 7), Imf::HALF);
    const std::string whole = scratch.get("test.exr");
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      EXPECT_TRUE(is_whole_or_refused(decode_exr(flipped, "t"))) << bit;
    }
  }
}

// The header's numbers, overwritten in place: nothing is allocated for what they claim.
TEST(Exr, ALyingHeaderIsRefused) {
  const Scratch scratch;
  put(scratch, Imf::Header(9, 7), test_image(9, 7));
  const std::string whole = scratch.get("test.exr");
  const auto with = [&](const std::string& attribute, std::size_t at, std::int32_t value) {
    std::string changed = whole;
    const std::size_t name = whole.find(attribute);
    const std::size_t type_end = whole.find('\0', name + attribute.size() + 1);
    std::memcpy(changed.data() + type_end + 1 + at, &value, sizeof value);
    return decode_exr(changed, "t");
  };
  constexpr std::size_t size = 0, right = 4 + 8, bottom = 4 + 12;
  for (const char* window : {"dataWindow", "displayWindow"}) {
    EXPECT_TRUE(fails(with(window, right, 2'000'000'000), Failure::content, "too large")) << window;
    EXPECT_TRUE(fails(with(window, right, -2'000'000'000), Failure::content, "without pixels")) << window;
    EXPECT_TRUE(fails(with(window, bottom, 65536), Failure::content, "too large")) << window;
  }
  EXPECT_TRUE(fails(with("channels", size, 2'000'000'000), Failure::content, "truncated or damaged"));
  EXPECT_TRUE(fails(with("dataWindow", bottom, 60000), Failure::content, "truncated"));
}

TEST(Exr, HugeTilesAreRefused) {
  const Scratch scratch;
  Imf::Header header(9, 7);
  header.setTileDescription(Imf::TileDescription(4, 4, Imf::ONE_LEVEL));
  put(scratch, header, test_image(9, 7));
  std::string bytes = scratch.get("test.exr");
  const std::size_t at = bytes.find("tiledesc", 8) + std::strlen("tiledesc") + 1 + 4;
  const std::uint32_t huge = 0x40000000;
  std::memcpy(bytes.data() + at + 4, &huge, 4);
  EXPECT_TRUE(fails(decode_exr(bytes, "t"), Failure::content, "tiles of 4x1073741824 pixels are too large"));
  std::memset(bytes.data() + at, 0, 4);
  EXPECT_TRUE(fails(decode_exr(bytes, "t"), Failure::content, "tile"));
}

TEST(Exr, WriterRefusesWhatDoesNotFit) {
  const Scratch scratch;
  const RgbImage image = test_image(3, 3);
  EXPECT_TRUE(fails(write_exr(scratch / "none/a.exr", image, {}), Failure::file, "No such file"));
  EXPECT_TRUE(fails(write_exr("/dev/full", image, {}), Failure::file, "No space left"));
  EXPECT_TRUE(fails(encode_exr(RgbImage{3, 3, {1, 2}, 0}, {}), Failure::internal, "do not fit"));
  EXPECT_TRUE(fails(encode_exr(RgbImage{}, {}), Failure::internal, "without pixels"));
  EXPECT_TRUE(fails(encode_exr(image, {{"", "x"}}), Failure::internal, "metadata name"));
  EXPECT_TRUE(fails(encode_exr(image, {{"channels", "x"}}), Failure::internal, "writing OpenEXR"));
  EXPECT_EQ(scratch.entries(), 0u);
}

}  // namespace
}  // namespace shabon::io
