// Colours of known shares, adaptation and spaces.
#include <gtest/gtest.h>

#include "shabon/desk/film_color.h"

namespace shabon::desk {
namespace {

color::Spectrum constant(double share) {
  color::Spectrum spectrum;
  spectrum.fill(share);
  return spectrum;
}

TEST(FilmColor, AGreyHasTheChromaticityOfTheLamp) {
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xyz white = color::white_point(lamp);
    const Color grey = color_of(constant(0.25), lamp);
    EXPECT_NEAR(grey.xyz.y, 0.25, 1e-14);
    EXPECT_NEAR(grey.xy.x, color::chromaticity(white).x, 1e-14);
    EXPECT_NEAR(grey.lab.a, 0, 1e-12);
    EXPECT_NEAR(grey.lab.b, 0, 1e-12);
    for (const color::AdaptationEntry& method : color::adaptations()) {
      const Color adapted = color_of(constant(0.25), lamp, color::observer_1931(), {method.method, {}});
      EXPECT_EQ(adapted.xyz, grey.xyz);
      EXPECT_EQ(adapted.lab, grey.lab);
      for (const double component : {adapted.linear_srgb.r, adapted.linear_srgb.g, adapted.linear_srgb.b})
        EXPECT_NEAR(component, 0.25, 1e-12) << lamp.name << " " << method.name;
    }
  }
}

TEST(FilmColor, IsTheSameFromXyz) {
  const color::Illuminant& lamp = color::illuminants()[1];
  const color::Observer& observer = *color::find_observer("1964");
  color::Spectrum share;
  for (std::size_t i = 0; i < share.size(); ++i) share[i] = static_cast<double>(i) / 470;
  const Color whole = color_of(share, lamp, observer), again = color_of(whole.xyz, color::white_point(lamp, observer));
  EXPECT_EQ(whole.lab, again.lab);
  EXPECT_EQ(whole.linear_srgb, again.linear_srgb);
  EXPECT_EQ(whole.srgb_mapped, again.srgb_mapped);
  EXPECT_NE(whole.lab, color_of(share, lamp).lab);
}

TEST(FilmColor, MapsIntoTheGamutAsAsked) {
  const color::Xyz violet{0.0126, 0.0053, 0.0279}, white = color::white_point(color::illuminants()[0]);
  const Color gently = color_of(violet, white), clipped = color_of(violet, white, {{}, color::GamutMapping::clip});
  EXPECT_FALSE(gently.in_gamut);
  EXPECT_LT(gently.linear_srgb.g, 0);
  EXPECT_EQ(clipped.srgb_mapped, clipped.srgb);
  EXPECT_NE(gently.srgb_mapped, gently.srgb);
}

TEST(FilmColor, SpacesWithAWhiteAreAdapted) {
  const color::Xyz white = color::white_point(color::illuminants()[1]);  // of A
  const color::Xyz colour{0.3, 0.2, 0.1};
  for (const color::ColorSpaceEntry& entry : color::color_spaces()) {
    const auto plain = in_space(entry.space, colour, white);
    EXPECT_EQ(plain, color::from_xyz(entry.space, colour, white)) << entry.name;
    const auto adapted = in_space(entry.space, colour, white, color::Adaptation::bradford);
    EXPECT_EQ(adapted == plain, !color::white_of(entry.space).has_value()) << entry.name;
  }
  for (const double component : in_space(color::ColorSpace::DisplayP3, white, white, color::Adaptation::cat16))
    EXPECT_NEAR(component, 1, 1e-12);
}

}  // namespace
}  // namespace shabon::desk
