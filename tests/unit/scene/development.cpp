#include "shabon/scene/development.h"

#include <gtest/gtest.h>

#include "shabon/color/rgb.h"
#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

TEST(Development, the_white_of_every_lamp_becomes_that_of_d65) {
  const color::Illuminant& d65 = color::illuminants().front();
  const color::Xyz white = color::white_point(d65);
  for (const color::Illuminant& lamp : color::illuminants()) {
    SceneDesc description;
    description.image.white_balance = lamp.name;
    const auto scene = compile(description, Resources{});
    ASSERT_TRUE(scene.ok()) << lamp.name;
    EXPECT_EQ(scene->development.white_lamp, lamp.name);
    const color::Xyz balanced = scene->development.balanced(color::white_point(lamp));
    EXPECT_NEAR(balanced.x, white.x, 1e-12) << lamp.name;
    EXPECT_NEAR(balanced.y, white.y, 1e-12) << lamp.name;
    EXPECT_NEAR(balanced.z, white.z, 1e-12) << lamp.name;
    // Other colours as equation (44) has them.
    const color::Xyz red{0.3, 0.2, 0.05};
    const color::Xyz expected = color::adapt(red, color::white_point(lamp), white, color::Adaptation::bradford);
    EXPECT_NEAR(scene->development.balanced(red).x, expected.x, 1e-12) << lamp.name;
    EXPECT_NEAR(scene->development.balanced(red).z, expected.z, 1e-12) << lamp.name;
  }
}

TEST(Development, nothing_is_adapted_by_default) {
  const auto scene = compile(SceneDesc{}, Resources{});
  ASSERT_TRUE(scene.ok());
  EXPECT_FALSE(scene->development.white_balance.has_value());
  EXPECT_EQ(scene->development.exposure_ev, 0);
}

TEST(Development, computed_lamps_serve_but_a_line_of_red_or_violet_does_not) {
  for (const char* lamp : {"blackbody:1000K", "blackbody:2856K", "blackbody:100000K", "daylight:4000K"})
    EXPECT_TRUE(white_balance_for(*color::illuminant_named(lamp)).ok()) << lamp;
  for (const double nm : {430.0, 650.0}) {
    const double at[] = {nm - 10, nm, nm + 10}, power[] = {0, 1, 0};
    const auto lamp = color::illuminant_from_samples("line", "", at, power);
    ASSERT_TRUE(lamp.ok());
    EXPECT_FALSE(white_balance_for(*lamp).ok()) << nm;
  }
}

}  // namespace
}  // namespace shabon::scene
