// Pictures as numbers: what is read is what stands in the file, in its depth.
#include "shabon/io/texture_image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstring>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include "scratch.h"

namespace shabon::io {
namespace {

struct Kind {
  int color_type, bits, samples, channels;  // `channels` of the texture that is read
};

constexpr Kind png_kinds[] = {
    {PNG_COLOR_TYPE_GRAY, 1, 1, 1},        {PNG_COLOR_TYPE_GRAY, 2, 1, 1},       {PNG_COLOR_TYPE_GRAY, 4, 1, 1},
    {PNG_COLOR_TYPE_GRAY, 8, 1, 1},        {PNG_COLOR_TYPE_GRAY, 16, 1, 1},      {PNG_COLOR_TYPE_GRAY_ALPHA, 8, 2, 1},
    {PNG_COLOR_TYPE_GRAY_ALPHA, 16, 2, 1}, {PNG_COLOR_TYPE_RGB, 8, 3, 3},        {PNG_COLOR_TYPE_RGB, 16, 3, 3},
    {PNG_COLOR_TYPE_RGB_ALPHA, 8, 4, 3},   {PNG_COLOR_TYPE_RGB_ALPHA, 16, 4, 3}, {PNG_COLOR_TYPE_PALETTE, 8, 1, 3},
};

unsigned sample_at(int x, int y, int c, int bits) {
  const unsigned value =
      static_cast<unsigned>(x) * 40503u + static_cast<unsigned>(y) * 10007u + static_cast<unsigned>(c) * 29123u + 257u;
  return value & ((1u << bits) - 1);
}

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// A picture of sample_at(), packed by hand; a palette of 256 grey-blue colours.
std::string png_of(const Kind& kind, int width, int height, bool interlaced) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const std::size_t row_bytes = (static_cast<std::size_t>(width * kind.samples * kind.bits) + 7) / 8;
  std::vector<std::uint8_t> data(row_bytes * static_cast<std::size_t>(height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y) {
    std::uint8_t* row = data.data() + row_bytes * static_cast<std::size_t>(y);
    rows.push_back(row);
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < kind.samples; ++c) {
        const unsigned value = sample_at(x, y, c, kind.bits);
        const int bit = (x * kind.samples + c) * kind.bits;
        if (kind.bits == 16) {
          row[bit / 8] = static_cast<std::uint8_t>(value >> 8);
          row[bit / 8 + 1] = static_cast<std::uint8_t>(value);
        } else {
          row[bit / 8] = static_cast<std::uint8_t>(row[bit / 8] | value << (8 - kind.bits - bit % 8));
        }
      }
  }
  png_set_write_fn(png, &bytes, append, [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind.bits, kind.color_type,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
    std::vector<png_color> palette;
    for (unsigned i = 0; i < 256; ++i)
      palette.push_back({static_cast<png_byte>(i), static_cast<png_byte>(i), static_cast<png_byte>(255 - i)});
    png_set_PLTE(png, info, palette.data(), 256);
  }
  png_set_gAMA(png, info, 0.3);  // is not applied
  png_write_info(png, info);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

testing::AssertionResult whole_or_refused(const Result<TextureImage>& image) {
  if (!image) return fails(image, Failure::content, "");
  const auto values = static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height) *
                      static_cast<std::size_t>(image->channels);
  if (image->values.size() != values) return testing::AssertionFailure() << image->values.size() << " values";
  for (const float value : image->values)
    if (!std::isfinite(value) || value < 0) return testing::AssertionFailure() << value;
  return testing::AssertionSuccess();
}

TEST(PngTexture, KeepsEveryNumberOfEveryKind) {
  for (const Kind& kind : png_kinds)
    for (const bool interlaced : {false, true}) {
      SCOPED_TRACE(testing::Message() << "type " << kind.color_type << ", " << kind.bits << " bits, " << interlaced);
      const auto image = decode_png_texture(png_of(kind, 13, 9, interlaced), "t");
      ASSERT_TRUE(image) << errors_of(image);
      ASSERT_EQ(image->width, 13);
      ASSERT_EQ(image->height, 9);
      ASSERT_EQ(image->channels, kind.channels);
      EXPECT_TRUE(image->whole_numbers);
      EXPECT_EQ(image->bits, kind.bits);
      const double largest = (1 << kind.bits) - 1;
      std::size_t at = 0;
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 13; ++x)
          for (int c = 0; c < kind.channels; ++c) {
            unsigned value = sample_at(x, y, c, kind.bits);
            if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
              value = sample_at(x, y, 0, 8);
              if (c == 2) value = 255 - value;
            }
            ASSERT_NEAR(image->values[at++], value / largest, 1e-7) << x << " " << y << " " << c;
          }
    }
}

TEST(PngTexture, EveryPrefixIsTruncated) {
  for (const Kind& kind : png_kinds) {
    const std::string whole = png_of(kind, 11, 9, kind.bits == 8);
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_TRUE(fails(decode_png_texture(std::string_view(whole).substr(0, length), "t"), Failure::content, "PNG"))
          << length;
  }
}

TEST(PngTexture, SurvivesFlippedBits) {
  for (const Kind& kind : png_kinds) {
    const std::string whole = png_of(kind, 5, 3, kind.bits == 16);
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      EXPECT_TRUE(whole_or_refused(decode_png_texture(flipped, "t"))) << bit;
    }
  }
}

TEST(PngTexture, SizesNoReaderTakesAreRefused) {
  // The header's chunk with its check sum: 65537 x 1, and 65536 x 65536 of one bit.
  const auto with_size = [](std::uint32_t width, std::uint32_t height) {
    std::string bytes = png_of(png_kinds[0], 3, 3, false);
    const auto put = [&](std::size_t at, std::uint32_t value) {
      for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
    };
    put(16, width);
    put(20, height);
    std::uint32_t crc = ~0u;  // ISO 3309, as PNG's annex D has it
    for (std::size_t at = 12; at < 29; ++at) {
      crc ^= static_cast<std::uint8_t>(bytes[at]);
      for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
    }
    put(29, ~crc);
    return bytes;
  };
  ASSERT_TRUE(decode_png_texture(with_size(3, 3), "t"));
  EXPECT_TRUE(fails(decode_png_texture(with_size(65537, 1), "t"), Failure::content, "PNG"));
  EXPECT_TRUE(fails(decode_png_texture(with_size(65536, 65536), "t"), Failure::content, "too large"));
  EXPECT_TRUE(fails(decode_png_texture(with_size(16384, 16384), "t"), Failure::content, "truncated"));
}

// A picture of the channels that are named; channel i of pixel p holds 100 i + p / 4.
std::string exr_of(const Scratch& scratch, const std::vector<std::string>& names, Imf::PixelType type = Imf::FLOAT,
                   float changed = 0.5f, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
  constexpr int width = 7, height = 5;
  const std::string path = (scratch / "test.exr").string();
  Imf::Header header(width, height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, compression);
  Imf::FrameBuffer buffer;
  std::vector<std::vector<float>> values(names.size());
  std::vector<std::vector<half>> halves(names.size());
  std::vector<std::vector<unsigned>> wholes(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(type));
    for (int p = 0; p < width * height; ++p) values[i].push_back(100 * static_cast<float>(i) + 0.25f * p);
    values[i][16] = changed;  // pixel (2, 2)
    halves[i].assign(values[i].begin(), values[i].end());
    if (type == Imf::UINT) wholes[i].assign(values[i].begin(), values[i].end());
    char* base = type == Imf::HALF    ? reinterpret_cast<char*>(halves[i].data())
                 : type == Imf::FLOAT ? reinterpret_cast<char*>(values[i].data())
                                      : reinterpret_cast<char*>(wholes[i].data());
    const std::size_t size = type == Imf::HALF ? 2 : 4;
    buffer.insert(names[i], Imf::Slice(type, base, size, size * width));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(height);
  return path;
}

TEST(ExrTexture, ReadsTheOneChannelThatHasTheNumbers) {
  const Scratch scratch;
  struct Case {
    std::vector<std::string> names;
    int chosen;
  };
  for (const auto& [names, chosen] : {Case{{"Y"}, 0}, Case{{"R"}, 0}, Case{{"Z"}, 0}, Case{{"film.thickness"}, 0},
                                      Case{{"A", "Y"}, 1}, Case{{"A", "R"}, 1}, Case{{"Z", "Y"}, 1}})
    for (const Imf::PixelType type : {Imf::FLOAT, Imf::HALF, Imf::UINT}) {
      const auto image = read_texture_image(exr_of(scratch, names, type, 3));
      ASSERT_TRUE(image) << errors_of(image);
      EXPECT_EQ(image->width, 7);
      EXPECT_EQ(image->height, 5);
      EXPECT_EQ(image->channels, 1);
      EXPECT_FALSE(image->whole_numbers);
      ASSERT_EQ(image->values.size(), 35u);
      for (std::size_t p = 0; p < 35; ++p) {
        const float value = p == 16 ? 3 : 100 * static_cast<float>(chosen) + 0.25f * static_cast<float>(p);
        EXPECT_EQ(image->values[p], type == Imf::UINT ? std::floor(value) : value) << names.back() << p;
      }
    }
}

TEST(ExrTexture, ReadsColours) {
  const Scratch scratch;
  const auto image = read_texture_image(exr_of(scratch, {"R", "G", "B", "A"}, Imf::FLOAT, -1));
  ASSERT_TRUE(image) << errors_of(image);
  EXPECT_EQ(image->channels, 3);
  EXPECT_EQ(image->negatives, 3);
  EXPECT_EQ(image->values[3], 0.25f);
  EXPECT_EQ(image->values[4], 100.25f);
  EXPECT_EQ(image->values[3 * 16 + 2], 0);
}

TEST(ExrTexture, UnclearChannelsAreRefusedByName) {
  const Scratch scratch;
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"G", "R"}, {"B", "G"}, {"BY", "RY", "Y"}, {"U", "V"}, {"left.R", "right.R"}})
    EXPECT_TRUE(fails(read_texture_image(exr_of(scratch, names)), Failure::content,
                      "one channel of numbers, or R, G and B; found: " + names[0] + ", " + names[1]));
}

TEST(ExrTexture, NamesTheBadPixel) {
  const Scratch scratch;
  const std::string place = "pixel (2, 2), counted from the top left, is ";
  EXPECT_TRUE(fails(read_texture_image(exr_of(scratch, {"Y"}, Imf::FLOAT, NAN)), Failure::content,
                    place + "not a number in Y"));
  EXPECT_TRUE(fails(read_texture_image(exr_of(scratch, {"Z"}, Imf::HALF, INFINITY)), Failure::content,
                    place + "infinite in Z"));
  EXPECT_TRUE(
      fails(read_texture_image(exr_of(scratch, {"R"}, Imf::FLOAT, -1)), Failure::content, place + "negative in R"));
  const auto zero = read_texture_image(exr_of(scratch, {"R"}, Imf::FLOAT, -0.0f));
  ASSERT_TRUE(zero);
  EXPECT_FALSE(std::signbit(zero->values[16]));
}

TEST(ExrTexture, EveryPrefixIsTruncatedAndFlippedBitsSurvive) {
  const Scratch scratch;
  for (const Imf::Compression compression : {Imf::NO_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
    exr_of(scratch, {"Y"}, Imf::HALF, 0.5f, compression);
    const std::string whole = scratch.get("test.exr");
    ASSERT_TRUE(decode_exr_texture(whole, "t"));
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_TRUE(fails(decode_exr_texture(std::string_view(whole).substr(0, length), "t"), Failure::content, ""))
          << length;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      std::string flipped = whole;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
      EXPECT_TRUE(whole_or_refused(decode_exr_texture(flipped, "t"))) << bit;
    }
  }
}

// The data window leaves most of the picture out: zeros there.
TEST(ExrTexture, PlacesTheDataWindow) {
  const Scratch scratch;
  const std::string path = (scratch / "window.exr").string();
  Imf::Header header(Imath::Box2i({10, 20}, {15, 23}), Imath::Box2i({12, 21}, {13, 21}));
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  std::vector<float> values{3, 4};
  Imf::FrameBuffer buffer;
  buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), Imath::V2i(12, 21), 2, 1));
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(1);
  }
  const auto image = read_texture_image(path);
  ASSERT_TRUE(image) << errors_of(image);
  std::vector<float> expected(6 * 4, 0.0f);
  expected[6 + 2] = 3;
  expected[6 + 3] = 4;
  EXPECT_EQ(image->values, expected);
}

TEST(TextureImage, TellsKindsApart) {
  const Scratch scratch;
  EXPECT_TRUE(read_texture_image(scratch.put("a", png_of(png_kinds[4], 3, 3, false)))->whole_numbers);
  EXPECT_TRUE(fails(read_texture_image(scratch.put("b", "GIF89a")), Failure::content,
                    "expected a picture in PNG (.png), JPEG (.jpg), OpenEXR (.exr) or Radiance (.hdr), got GIF"));
  EXPECT_TRUE(fails(read_texture_image(scratch.put("c", "")), Failure::content, "an empty file"));
  EXPECT_TRUE(fails(read_texture_image(scratch / "none"), Failure::file, ""));
  std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
  hdr += std::string("\x80\x40\x20\x81", 4);
  const auto colors = read_texture_image(scratch.put("d", hdr));
  ASSERT_TRUE(colors) << errors_of(colors);
  EXPECT_EQ(colors->channels, 3);
  EXPECT_NEAR(colors->values[1], 0.5, 0.01);
}

}  // namespace
}  // namespace shabon::io
