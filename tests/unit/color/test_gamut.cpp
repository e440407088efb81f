#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "newton_series.h"
#include "shabon/base/random.h"
#include "shabon/color/gamut.h"
#include "shabon/color/gamut_line.h"
#include "shabon/color/lab.h"
#include "shabon/color/oklab.h"

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

double hue_difference_deg(LinearRgb first, LinearRgb second) {
  const Oklab p = linear_srgb_to_oklab(first), q = linear_srgb_to_oklab(second);
  return std::abs(std::atan2(p.a * q.b - p.b * q.a, p.a * q.a + p.b * q.b)) * 180 / std::numbers::pi;
}

double difference(LinearRgb first, LinearRgb second) {
  const Xyz white = linear_srgb_to_xyz({1, 1, 1});
  return ciede2000(xyz_to_lab(linear_srgb_to_xyz(first), white), xyz_to_lab(linear_srgb_to_xyz(second), white));
}

class EveryMapping : public testing::TestWithParam<GamutMappingEntry> {
 protected:
  LinearRgb map(LinearRgb colour) const { return map_to_srgb_gamut(colour, GetParam().mapping); }
};

// Those that leave the inside alone.
class KeepingMapping : public EveryMapping {};

TEST_P(EveryMapping, IsFoundByItsName) {
  EXPECT_EQ(find_gamut_mapping(GetParam().name), GetParam().mapping);
  EXPECT_EQ(name_of(GetParam().mapping), GetParam().name);
  EXPECT_FALSE(GetParam().description.empty());
  EXPECT_FALSE(find_gamut_mapping("no such mapping"));
}

TEST_P(KeepingMapping, LeavesTheGamutAlone) {
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
    if (GetParam().keeps_inside) {
      EXPECT_EQ(map(mapped), mapped);
    }
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
  EXPECT_EQ(map({nan, 0.25, 0.5}), map({0, 0.25, 0.5}));
}

TEST_P(EveryMapping, BrighterThanWhiteIsWhite) {
  // Ten digits of Oklab's matrix leave white a chroma of 1e-10, near whose corner the boundary is steep.
  const double nearly = GetParam().keeps_inside ? 1e-9 : 1e-4;
  for (const double v : {1 + 1e-12, 1.5, 20.0, 1e6}) EXPECT_LT(distance(map({v, v, v}), {1, 1, 1}), nearly) << v;
  EXPECT_EQ(map({-1, -2, -0.5}), (LinearRgb{0, 0, 0}));
}

// From just outside, a colour must land where it left the cube. Along lines of constant Oklab hue this fails by 0.1
// near the blue corner.
TEST_P(KeepingMapping, MeetsTheGamutsBoundary) {
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

std::string test_name(const testing::TestParamInfo<GamutMappingEntry>& entry) {
  std::string name(entry.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<GamutMappingEntry> keeping_mappings() {
  std::vector<GamutMappingEntry> entries;
  for (const GamutMappingEntry& entry : gamut_mappings())
    if (entry.keeps_inside) entries.push_back(entry);
  return entries;
}

INSTANTIATE_TEST_SUITE_P(Gamut, EveryMapping, testing::ValuesIn(gamut_mappings().begin(), gamut_mappings().end()),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Gamut, KeepingMapping, testing::ValuesIn(keeping_mappings()), test_name);

TEST(GamutMappings, TheDefaultKeepsTheInside) {
  const auto keeping = keeping_mappings();
  EXPECT_TRUE(std::any_of(keeping.begin(), keeping.end(),
                          [](const GamutMappingEntry& entry) { return entry.mapping == default_gamut_mapping; }));
}

// What the mappings are for, over the film colours outside sRGB.
struct Series {
  const char* lamp;
  double gain;
  bool transmitted;
};

std::vector<LinearRgb> colours_of(const Series& series, double step_nm = 1) {
  std::vector<LinearRgb> colours;
  for (double d = step_nm; d <= 2000; d += step_nm)
    colours.push_back(newton_colour(d, series.gain, *find_illuminant(series.lamp), series.transmitted));
  return colours;
}

struct Loss {
  int outside = 0;
  double worst_hue_deg = 0, worst_lightness = 0, mean_difference = 0, chroma_kept = 0;
};

Loss loss_of(const std::vector<LinearRgb>& colours, GamutMapping mapping) {
  Loss loss;
  for (const LinearRgb& colour : colours) {
    if (in_srgb_gamut(colour)) continue;
    ++loss.outside;
    const LinearRgb mapped = map_to_srgb_gamut(colour, mapping);
    const Oklab wanted = linear_srgb_to_oklab(colour), shown = linear_srgb_to_oklab(mapped);
    const double chroma = std::hypot(shown.a, shown.b);
    constexpr double hue_is_seen = 0.01;
    if (chroma > hue_is_seen) loss.worst_hue_deg = std::max(loss.worst_hue_deg, hue_difference_deg(colour, mapped));
    loss.worst_lightness = std::max(loss.worst_lightness, std::abs(shown.L - wanted.L));
    loss.mean_difference += difference(colour, mapped);
    loss.chroma_kept += chroma / std::hypot(wanted.a, wanted.b);
  }
  loss.mean_difference /= loss.outside;
  loss.chroma_kept /= loss.outside;
  return loss;
}

constexpr Series reflected_d65{"D65", 1, false}, reflected_a{"A", 12, false}, transmitted_a{"A", 1, true};

TEST(ReduceChroma, KeepsHueAndLightnessOfFilmColours) {
  const auto colours = colours_of(reflected_d65);
  const Loss loss = loss_of(colours, GamutMapping::reduce_chroma);
  EXPECT_EQ(loss.outside, 193);  // of 2000
  EXPECT_LT(loss.worst_hue_deg, 2.5);
  EXPECT_LT(loss.worst_lightness, 3e-4);
  EXPECT_GT(loss_of(colours, GamutMapping::clip).worst_hue_deg, 10);
}

// The figures of docs/physics.md, (20).
TEST(KeepHue, LosesLittleOfFilmColours) {
  for (const Series& series : {reflected_d65, reflected_a, transmitted_a}) {
    const auto colours = colours_of(series);
    for (const GamutMappingEntry& entry : gamut_mappings()) {
      const Loss loss = loss_of(colours, entry.mapping);
      std::printf(
          "[ measured ] %s x%g %s, %-13s: %4d outside, hue %5.2f degrees, lightness %.3f, dE2000 %5.2f, chroma %.2f\n",
          series.lamp, series.gain, series.transmitted ? "transmitted" : "reflected  ", std::string(entry.name).c_str(),
          loss.outside, loss.worst_hue_deg, loss.worst_lightness, loss.mean_difference, loss.chroma_kept);
    }
    const Loss kept = loss_of(colours, GamutMapping::keep_hue), reduced = loss_of(colours, GamutMapping::reduce_chroma);
    EXPECT_LT(kept.worst_hue_deg, 3.2) << series.lamp;
    EXPECT_LT(kept.mean_difference, 0.92 * reduced.mean_difference) << series.lamp;
    EXPECT_GT(kept.chroma_kept, reduced.chroma_kept + 0.03) << series.lamp;
    EXPECT_LT(kept.worst_lightness, 0.11) << series.lamp;
  }
}

// What a film lets through under A is orange, brighter in its red than sRGB can show, and not white.
TEST(KeepHue, LeavesBrightLampsTheirColour) {
  const LinearRgb colour = newton_colour(300, 1, *find_illuminant("A"), true);
  ASSERT_GT(colour.r, 1.5);
  const LinearRgb white = map_to_srgb_gamut(colour, GamutMapping::reduce_chroma);
  EXPECT_LT(distance(white, {1, 1, 1}), 0.1);
  for (const GamutMapping mapping : {GamutMapping::keep_hue, GamutMapping::gentle}) {
    const LinearRgb mapped = map_to_srgb_gamut(colour, mapping);
    EXPECT_LT(mapped.b, 0.6);
    EXPECT_LT(mapped.g, 0.8);
    EXPECT_GT(mapped.r, 0.85);
  }
}

// The root mean square change of slope from one nanometre to the next, in Oklab: what shows as edges in a band of
// colours.
double roughness(const std::vector<LinearRgb>& colours, GamutMapping mapping) {
  std::vector<Oklab> shown;
  for (const LinearRgb& c : colours) shown.push_back(linear_srgb_to_oklab(map_to_srgb_gamut(c, mapping)));
  double sum = 0;
  for (std::size_t i = 1; i + 1 < shown.size(); ++i) {
    const double l = shown[i - 1].L - 2 * shown[i].L + shown[i + 1].L,
                 a = shown[i - 1].a - 2 * shown[i].a + shown[i + 1].a,
                 b = shown[i - 1].b - 2 * shown[i].b + shown[i + 1].b;
    sum += l * l + a * a + b * b;
  }
  return std::sqrt(sum / static_cast<double>(shown.size()));
}

TEST(Gentle, SoftensTheEdgesWhereManyColoursLieOutside) {
  auto colours = colours_of(reflected_a);
  colours.erase(colours.begin(), colours.begin() + 50);  // where black begins, roots are steep whatever the mapping
  for (const GamutMappingEntry& entry : gamut_mappings())
    std::printf("[ measured ] %-13s: roughness %.2g per nm\n", std::string(entry.name).c_str(),
                roughness(colours, entry.mapping));
  EXPECT_LT(roughness(colours, GamutMapping::gentle), 0.85 * roughness(colours, GamutMapping::keep_hue));
}

TEST(Gentle, LeavesTheInnerGamutAlone) {
  Pcg32 random(5);
  for (int i = 0; i < 5000; ++i) {
    const LinearRgb colour = random_colour(random, 0.3, 0.5);
    constexpr double digits_of_the_matrices = 1e-9;
    EXPECT_LT(distance(map_to_srgb_gamut(colour, GamutMapping::gentle), colour), digits_of_the_matrices);
  }
}

// Outwards along a hue no two colours become one, also beyond the boundary; with the other mappings they do.
TEST(Gentle, KeepsApartWhatLiesBeyond) {
  Pcg32 random(7);
  for (int i = 0; i < 300; ++i) {
    const LinearRgb inner = random_colour(random, 0.05, 0.9);
    const RootColor root = root_color({inner.r, inner.g, inner.b});
    if (root.chroma < 0.02) continue;
    const GamutLine line(root, root.lightness);
    double last = 0;
    for (double t = 0.02; t < 1.4 * line.exit(); t += 0.01 * line.exit()) {
      const Vector3 c = line.at(t);
      const LinearRgb mapped = map_to_srgb_gamut({c[0], c[1], c[2]}, GamutMapping::gentle);
      const double chroma = root_color({mapped.r, mapped.g, mapped.b}).chroma;
      ASSERT_GT(chroma, last) << inner.r << " " << inner.g << " " << inner.b << " at " << t / line.exit();
      last = chroma;
    }
  }
}

TEST(CuspLightness, IsThatOfTheStrongestColours) {
  Pcg32 random(6);
  for (int edge = 0; edge < 6; ++edge) {
    for (int i = 0; i < 200; ++i) {
      Vector3 c{1, 0, 0};
      const double share = random.uniform(0.001, 0.999);
      const Vector3 on[] = {{1, share, 0}, {share, 1, 0}, {0, 1, share}, {0, share, 1}, {share, 0, 1}, {1, 0, share}};
      c = on[edge];
      const RootColor colour = root_color(c);
      EXPECT_NEAR(cusp_lightness(colour.a, colour.b), colour.lightness, 1e-10);
      const double size = random.uniform(1e-9, 10);
      EXPECT_NEAR(cusp_lightness(size * colour.a, size * colour.b), colour.lightness, 1e-10);
    }
  }
}

TEST(InSrgbGamut, CountsTheToleranceOnBothSides) {
  EXPECT_TRUE(in_srgb_gamut({0, 0.5, 1}));
  EXPECT_FALSE(in_srgb_gamut({-1e-9, 0.5, 1}));
  EXPECT_FALSE(in_srgb_gamut({0, 0.5, 1 + 1e-9}));
  EXPECT_TRUE(in_srgb_gamut({-1e-9, 0.5, 1 + 1e-9}, 1e-8));
  EXPECT_FALSE(in_srgb_gamut({std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5}, 1));
}

}  // namespace
