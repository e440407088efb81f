#include "shabon/render/develop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shabon/color/rgb.h"

namespace shabon::render {
namespace {

// One grey pixel per brightness, lit by the lamp.
Sensor greys_under(const color::Illuminant& lamp) {
  Sensor sensor(8, 1);
  const color::Xyz white = color::white_point(lamp);
  for (int x = 0; x < 8; ++x) {
    const double grey = 0.9 * std::exp2(-x);
    sensor.at(x, 0) = {2 * grey * white.x, 2 * grey * white.y, 2 * grey * white.z, 2};
  }
  return sensor;
}

int unevenness(const std::vector<std::uint8_t>& bytes) {
  int worst = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto [low, high] = std::minmax({bytes[i], bytes[i + 1], bytes[i + 2]});
    worst = std::max(worst, high - low);
  }
  return worst;
}

scene::Development balanced_for(const color::Illuminant& lamp, double exposure_ev) {
  scene::Development development;
  development.exposure_ev = exposure_ev;
  development.white_lamp = lamp.name;
  development.white_balance = scene::white_balance_for(lamp).value();
  return development;
}

// 8 bits tell the tabulated D65 from the standard's white by no more than one step.
TEST(Develop, a_grey_is_neutral_under_the_lamp_of_the_white_balance) {
  for (const color::Illuminant& lamp : color::illuminants()) {
    const Sensor sensor = greys_under(lamp);
    for (const double ev : {-2.0, 0.0, 0.1})
      EXPECT_LE(unevenness(develop_srgb8(sensor, balanced_for(lamp, ev))), 1) << lamp.name << ' ' << ev;
  }
  const color::Illuminant& a = *color::find_illuminant("A");
  EXPECT_GT(unevenness(develop_srgb8(greys_under(a), {})), 40);
}

TEST(Develop, exposure_doubles_the_light) {
  const Sensor sensor = greys_under(*color::find_illuminant("D65"));
  scene::Development brighter;
  brighter.exposure_ev = 1;
  const auto plain = develop_srgb8(sensor, {}), doubled = develop_srgb8(sensor, brighter);
  for (std::size_t i = 3; i < plain.size(); ++i) EXPECT_EQ(doubled[i], plain[i - 3]) << i;
}

TEST(Develop, linear_pictures_know_neither) {
  const color::Illuminant& a = *color::find_illuminant("A");
  const color::LinearRgb expected = color::xyz_to_linear_srgb(color::white_point(a));
  const io::RgbImage image = develop_linear(greys_under(a));
  EXPECT_NEAR(image.rgb[0], 0.9 * expected.r, 1e-6);
  EXPECT_NEAR(image.rgb[2], 0.9 * expected.b, 1e-6);
}

}  // namespace
}  // namespace shabon::render
