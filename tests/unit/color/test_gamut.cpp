#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "newton_series.h"
#include "shabon/base/random.h"
#include "shabon/color/gamut.h"

namespace {

using namespace shabon::color;
using shabon::Pcg32;

double distance(LinearRgb a, LinearRgb b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

LinearRgb mix(LinearRgb a, LinearRgb b, double t) {
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

LinearRgb random_colour(Pcg32& random, double low, double high) {
  return {random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
}

// Oklab's lightness, a and b, from its definition: B. Ottosson (2020).
std::array<double, 3> oklab(LinearRgb c) {
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

class EveryMapping : public testing::TestWithParam<GamutMappingEntry> {
 protected:
  LinearRgb map(LinearRgb colour) const { return map_to_srgb_gamut(colour, GetParam().mapping); }
};

TEST_P(EveryMapping, IsFoundByItsName) {
  EXPECT_EQ(find_gamut_mapping(GetParam().name), GetParam().mapping);
  EXPECT_EQ(name_of(GetParam().mapping), GetParam().name);
  EXPECT_FALSE(GetParam().description.empty());
  EXPECT_FALSE(find_gamut_mapping("no such mapping"));
}

TEST_P(EveryMapping, LeavesTheGamutAlone) {
  Pcg32 random(1);
  for (int i = 0; i < 10000; ++i) {
    const LinearRgb colour = random_colour(random, 0, 1);
    EXPECT_EQ(map(colour), colour);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const LinearRgb colour{double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)};
    EXPECT_EQ(map(colour), colour);
  }
}

TEST_P(EveryMapping, EndsInTheGamutAndMapsTwiceAsOnce) {
  Pcg32 random(2);
  const auto check = [this](LinearRgb colour) {
    const LinearRgb mapped = map(colour);
    EXPECT_TRUE(in_srgb_gamut(mapped)) << colour.r << " " << colour.g << " " << colour.b;
    EXPECT_EQ(map(mapped), mapped);
  };
  for (int i = 0; i < 20000; ++i) check(random_colour(random, -1, 3));
  for (int i = 0; i < 20000; ++i) check(random_colour(random, -1e-3, 1e-3));
  for (int d = 0; d <= 2000; d += 5)
    for (const double gain : {1.0, 12.0, 100.0}) check(newton_colour(d, gain));
}

TEST_P(EveryMapping, AnswersNumbersToAnything) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double values[] = {0, -0.0, 0.5, 1, 2, -1, 1e-300, 1e300, -1e300, inf, -inf, nan};
  for (const double r : values)
    for (const double g : values)
      for (const double b : values) EXPECT_TRUE(in_srgb_gamut(map({r, g, b}))) << r << " " << g << " " << b;
  EXPECT_EQ(map({nan, 0.25, 0.5}), (LinearRgb{0, 0.25, 0.5}));
}

TEST_P(EveryMapping, BrighterThanWhiteIsWhite) {
  for (const double v : {1 + 1e-12, 1.5, 20.0, 1e6}) EXPECT_LT(distance(map({v, v, v}), {1, 1, 1}), 1e-9) << v;
  EXPECT_EQ(map({-1, -2, -0.5}), (LinearRgb{0, 0, 0}));
}

// From just outside, a colour must land where it left the cube. Along lines of constant Oklab hue this fails by 0.1
// near the blue corner.
TEST_P(EveryMapping, MeetsTheGamutsBoundary) {
  Pcg32 random(3);
  for (int i = 0; i < 200000; ++i) {
    LinearRgb colour = random_colour(random, 0, 1);
    std::array<double*, 3> parts{&colour.r, &colour.g, &colour.b};
    const auto face = [&](int k) { *parts[k % 3] = k < 3 ? 0 : 1; };
    face(i % 6);
    if (i % 2) face((i % 6 + 1 + 3 * (i / 12 % 2)) % 6);  // an edge
    if (i % 4 == 3) colour = mix({0, 0, 1}, colour, 0.02);
    LinearRgb outside = colour;
    for (double* part : {&outside.r, &outside.g, &outside.b}) *part += *part == 0 ? -1e-10 : *part == 1 ? 1e-10 : 0;
    ASSERT_LT(distance(map(outside), colour), 1e-4) << colour.r << " " << colour.g << " " << colour.b;
  }
}

// Follows the largest change along random lines down to a step of 1e-11: a jump would stay.
TEST_P(EveryMapping, IsContinuous) {
  Pcg32 random(4);
  for (int line = 0; line < 300; ++line) {
    const double reach = line % 3 == 0 ? 3 : line % 3 == 1 ? 1.2 : 0.05;
    const LinearRgb from = random_colour(random, -reach / 2, reach), to = random_colour(random, -reach / 2, reach);
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i) {
      LinearRgb a = mix(from, to, i / double(steps)), b = mix(from, to, (i + 1) / double(steps));
      if (distance(map(a), map(b)) < 2.0 / steps * reach) continue;
      while (distance(a, b) > 1e-11) {
        const LinearRgb middle = mix(a, b, 0.5);
        if (distance(map(a), map(middle)) > distance(map(middle), map(b)))
          b = middle;
        else
          a = middle;
      }
      ASSERT_LT(distance(map(a), map(b)), 1e-4) << a.r << " " << a.g << " " << a.b;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gamut, EveryMapping, testing::ValuesIn(gamut_mappings().begin(), gamut_mappings().end()),
                         [](const auto& entry) {
                           std::string name(entry.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// What the mapping is for: over the film colours outside sRGB it keeps hue and lightness, which clipping does not.
TEST(ReduceChroma, KeepsHueAndLightnessOfFilmColours) {
  int outside = 0, all = 0;
  double worst_hue_deg = 0, worst_lightness = 0, worst_clipped_hue_deg = 0;
  for (int d = 1; d <= 2000; ++d) {
    ++all;
    const LinearRgb colour = newton_colour(d);
    if (in_srgb_gamut(colour)) continue;
    ++outside;
    const auto wanted = oklab(colour);
    const auto hue_off = [&wanted](LinearRgb c) {
      const auto lab = oklab(c);
      const double cross = wanted[1] * lab[2] - wanted[2] * lab[1], dot = wanted[1] * lab[1] + wanted[2] * lab[2];
      return std::abs(std::atan2(cross, dot)) * 180 / std::numbers::pi;
    };
    const LinearRgb mapped = map_to_srgb_gamut(colour, GamutMapping::reduce_chroma);
    worst_hue_deg = std::max(worst_hue_deg, hue_off(mapped));
    worst_lightness = std::max(worst_lightness, std::abs(oklab(mapped)[0] - wanted[0]));
    worst_clipped_hue_deg = std::max(worst_clipped_hue_deg, hue_off(map_to_srgb_gamut(colour, GamutMapping::clip)));
  }
  EXPECT_LT(worst_hue_deg, 2.5);
  EXPECT_LT(worst_lightness, 3e-4);
  EXPECT_GT(worst_clipped_hue_deg, 10);
  RecordProperty("outside_share", std::to_string(outside / double(all)));
  RecordProperty("worst_hue_deg", std::to_string(worst_hue_deg));
  RecordProperty("worst_lightness", std::to_string(worst_lightness));
}

TEST(InSrgbGamut, CountsTheToleranceOnBothSides) {
  EXPECT_TRUE(in_srgb_gamut({0, 0.5, 1}));
  EXPECT_FALSE(in_srgb_gamut({-1e-9, 0.5, 1}));
  EXPECT_FALSE(in_srgb_gamut({0, 0.5, 1 + 1e-9}));
  EXPECT_TRUE(in_srgb_gamut({-1e-9, 0.5, 1 + 1e-9}, 1e-8));
  EXPECT_FALSE(in_srgb_gamut({std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5}, 1));
}

}  // namespace
