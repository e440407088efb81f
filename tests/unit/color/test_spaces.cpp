#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "shabon/base/random.h"
#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/lab.h"
#include "shabon/color/rgb_space.h"
#include "shabon/color/spaces.h"

namespace {

using namespace shabon::color;

class EverySpace : public testing::TestWithParam<ColorSpaceEntry> {};

TEST_P(EverySpace, IsFoundByItsName) {
  const ColorSpaceEntry& entry = GetParam();
  EXPECT_EQ(find_color_space(entry.name), entry.space);
  EXPECT_EQ(find_color_space(shabon::lower(entry.name)), entry.space);
  EXPECT_EQ(name_of(entry.space), entry.name);
  EXPECT_FALSE(entry.description.empty());
  for (const auto component : entry.components) EXPECT_FALSE(component.empty());
}

TEST_P(EverySpace, BringsEveryColourBack) {
  shabon::Pcg32 random(1);
  for (const Illuminant& lamp : illuminants().first(4)) {
    const Xyz white = white_point(lamp);
    for (int i = 0; i < 2000; ++i) {
      const double size = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-3 : 20;
      const Xyz colour{random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)};
      const auto components = from_xyz(GetParam().space, colour, white);
      const Xyz back = to_xyz(GetParam().space, components, white);
      EXPECT_NEAR(back.x, colour.x, 1e-12 * size);
      EXPECT_NEAR(back.y, colour.y, 1e-12 * size);
      EXPECT_NEAR(back.z, colour.z, 1e-12 * size);
      const auto plain = decoded(GetParam().space, encoded(GetParam().space, components));
      for (std::size_t k = 0; k < 3; ++k)  // sRGB's two thresholds leave 1e-8
        EXPECT_NEAR(plain[k], components[k], 1e-8 + 1e-13 * std::abs(components[k]));
    }
  }
}

TEST_P(EverySpace, KnowsBlackAndItsWhite) {
  const Xyz white = white_point(*find_illuminant("A"));
  const auto black = from_xyz(GetParam().space, {0, 0, 0}, white);
  for (const double component : black) EXPECT_TRUE(std::isfinite(component));
  EXPECT_EQ(to_xyz(GetParam().space, black, white), (Xyz{0, 0, 0}));
  const auto own = white_of(GetParam().space);
  if (!own) return;
  EXPECT_EQ(own->y, 1);
  const auto components = from_xyz(GetParam().space, *own, white);
  const bool oklab = GetParam().space == ColorSpace::Oklab;
  EXPECT_NEAR(components[0], 1, 1e-8);  // the digits of Oklab
  EXPECT_NEAR(components[1], oklab ? 0 : 1, 1e-7);
  EXPECT_NEAR(components[2], oklab ? 0 : 1, 1e-7);
}

TEST_P(EverySpace, EncodesWithoutClipping) {
  const std::array<double, 3> values{-0.5, 0.001, 1.7};
  const auto shown = encoded(GetParam().space, values);
  if (!is_encoded(GetParam().space)) {
    EXPECT_EQ(shown, values);
    return;
  }
  EXPECT_EQ(shown[0], -encoded(GetParam().space, {0.5, 0, 0})[0]);
  EXPECT_GT(shown[2], 1);
  EXPECT_NEAR(encoded(GetParam().space, {0, 1, 0})[1], 1, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Spaces, EverySpace, testing::ValuesIn(color_spaces().begin(), color_spaces().end()),
                         [](const auto& entry) {
                           std::string name;
                           for (const char c : entry.param.name)
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

TEST(Spaces, AreNineAndOthersAreUnknown) {
  std::set<ColorSpace> spaces;
  for (const ColorSpaceEntry& entry : color_spaces()) spaces.insert(entry.space);
  EXPECT_EQ(spaces.size(), 9u);
  EXPECT_EQ(find_color_space("Display P3"), find_color_space("displayp3"));
  EXPECT_FALSE(find_color_space("CMYK"));
  EXPECT_FALSE(find_color_space(""));
}

TEST(Spaces, LchIsLabInPolarForm) {
  const Xyz white = white_point(*find_illuminant("D50")), colour{0.2, 0.3, 0.6};
  const Lab lab = xyz_to_lab(colour, white);
  const auto lch = from_xyz(ColorSpace::LCh, colour, white);
  EXPECT_EQ(lch[0], lab.L);
  EXPECT_NEAR(lch[1] * lch[1], lab.a * lab.a + lab.b * lab.b, 1e-10);
  EXPECT_GT(lch[2], 180);  // blue: both a and b are negative
  EXPECT_LT(lch[2], 270);
  EXPECT_NEAR(std::tan(lch[2] * std::acos(-1.0) / 180), lab.b / lab.a, 1e-12);
}

// The matrices differ from each other, so a space cannot pass for another one.
TEST(Spaces, PrimariesAreUnitVectors) {
  const struct {
    ColorSpace space;
    const RgbSpace& rgb;
  } spaces[] = {{ColorSpace::sRGB, srgb_space},
                {ColorSpace::DisplayP3, display_p3_space},
                {ColorSpace::Rec2020, rec2020_space},
                {ColorSpace::ACEScg, acescg_space}};
  for (const auto& [space, rgb] : spaces) {
    const Xy primaries[] = {rgb.red, rgb.green, rgb.blue};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto c = from_xyz(space, to_xyz(ColorSpace::xyY, {primaries[k].x, primaries[k].y, 0.5}, {}), {});
      EXPECT_GT(c[k], 0.1) << name_of(space);
      EXPECT_NEAR(c[(k + 1) % 3], 0, 1e-15) << name_of(space);
      EXPECT_NEAR(c[(k + 2) % 3], 0, 1e-15) << name_of(space);
    }
  }
}

}  // namespace
