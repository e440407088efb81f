// What surfaces take from files: textures and reflectances.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "shabon/api/reflectance_file.h"
#include "shabon/api/texture_file.h"
#include "shabon/io/image.h"

namespace shabon::api {
namespace {

namespace fs = std::filesystem;

class SurfaceFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "shabon-surfaces-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string reflectance_error(const std::string& text) const {
    const auto spectrum = read_reflectance_file(write("r.csv", text));
    return spectrum ? "" : to_text(spectrum.errors());
  }

  fs::path folder_;
};

TEST_F(SurfaceFiles, numbers_of_a_png_are_taken_as_they_stand) {
  const std::vector<std::uint8_t> rgb = {0, 51, 255, 102, 102, 102};
  ASSERT_TRUE(io::write_png(folder_ / "a.png", 2, 1, rgb, {}));
  const auto texture = read_texture(folder_ / "a.png");
  ASSERT_TRUE(texture.ok()) << to_text(texture.errors());
  EXPECT_TRUE(texture->whole_numbers);
  EXPECT_EQ(texture->bits, 8);
  ASSERT_EQ(texture->raster.values.size(), 6u);
  EXPECT_FLOAT_EQ(texture->raster.values[1], 0.2f);
  EXPECT_FLOAT_EQ(texture->raster.values[3], 0.4f);
}

TEST_F(SurfaceFiles, floating_pictures_hold_numbers_of_any_size) {
  io::RgbImage image;
  image.width = 1, image.height = 2, image.rgb = {300, 300, 300, 0, 0.5f, 1};
  ASSERT_TRUE(io::write_exr(folder_ / "a.bin", image, {}));  // told by content
  const auto texture = read_texture(folder_ / "a.bin");
  ASSERT_TRUE(texture.ok()) << to_text(texture.errors());
  EXPECT_FALSE(texture->whole_numbers);
  EXPECT_EQ(texture->raster.height, 2);
  EXPECT_EQ(texture->raster.values, image.rgb);
}

TEST_F(SurfaceFiles, what_is_no_picture_is_told) {
  for (const char* name : {"a.png", "a.exr"}) {
    const auto texture = read_texture(write(name, "not a picture"));
    ASSERT_FALSE(texture.ok());
    EXPECT_EQ(texture.errors().front().failure, Failure::content);
  }
  EXPECT_FALSE(read_texture(write("cut.png", "\x89PNG\r\n\x1a\n")).ok());
  const auto missing = read_texture(folder_ / "missing.png");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.errors().front().failure, Failure::file);
}

TEST_F(SurfaceFiles, a_reflectance_is_linear_between_its_wavelengths_and_held_beyond) {
  const auto spectrum = read_reflectance_file(write("r.csv", "wavelength_nm,reflectance\n700,0.8\n400,0.2\n"));
  ASSERT_TRUE(spectrum.ok()) << to_text(spectrum.errors());
  EXPECT_DOUBLE_EQ((*spectrum)[0], 0.2);
  EXPECT_DOUBLE_EQ((*spectrum)[400 - 360], 0.2);
  EXPECT_NEAR((*spectrum)[550 - 360], 0.5, 1e-15);
  EXPECT_DOUBLE_EQ((*spectrum)[700 - 360], 0.8);
  EXPECT_DOUBLE_EQ((*spectrum)[470], 0.8);
}

TEST_F(SurfaceFiles, reflectances_that_cannot_be_are_told) {
  EXPECT_NE(reflectance_error("wavelength_nm,R\n400,0.2\n500,1.2\n").find("0..1, got 1.2 at 500 nm"),
            std::string::npos);
  EXPECT_NE(reflectance_error("wavelength_nm,R\n400,0.2\n400,0.3\n").find("got two at 400 nm"), std::string::npos);
  EXPECT_NE(reflectance_error("wavelength_nm,angle_deg,R\n400,0,0.2\n500,60,0.3\n").find("at one angle"),
            std::string::npos);
  EXPECT_NE(reflectance_error("wavelength_nm,T\n400,0.2\n500,0.3\n"), "");
}

}  // namespace
}  // namespace shabon::api
