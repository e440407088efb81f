#include "shabon/scene/pixel_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "shabon/base/text.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/schema_fields.h"

namespace shabon::scene {
namespace {

constexpr double widths_px[] = {0.25, 1, 2, 3, 7.5, 64};

// Integral of shape(t) g(x) over the width, x in pixels, by the midpoint rule.
template <class Function>
double integral(const FilterEntry& entry, double width_px, const Function& g) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * (i + 0.5) / steps - 1;
    sum += entry.shape(t) * g(t * width_px / 2);
  }
  return sum * width_px / steps;
}

TEST(PixelFilter, samples_have_the_moments_of_the_curve) {
  for (const FilterEntry& entry : pixel_filters)
    for (const double width_px : widths_px) {
      const PixelFilter filter(entry.kind, width_px);
      const double total = integral(entry, width_px, [](double) { return 1; });
      constexpr int samples = 1 << 16;
      double moments[5] = {};
      for (int i = 0; i < samples; ++i) {
        const double x = filter.offset_px((i + 0.5) / samples);
        ASSERT_LE(std::abs(x), width_px / 2 * (1 + 1e-12)) << entry.name;
        for (int m = 1; m <= 4; ++m) moments[m] += std::pow(x, m) / samples;
      }
      for (int m = 1; m <= 4; ++m) {
        const double expected = integral(entry, width_px, [m](double x) { return std::pow(x, m); }) / total;
        EXPECT_NEAR(moments[m], expected, 1e-5 * std::pow(width_px, m)) << entry.name << ' ' << width_px << ' ' << m;
      }
    }
}

// offset_px is the inverse of the cumulative of density, and density is the curve.
TEST(PixelFilter, offsets_invert_the_cumulative) {
  for (const FilterEntry& entry : pixel_filters) {
    const PixelFilter filter(entry.kind);
    EXPECT_EQ(filter.width_px(), entry.default_width_px);
    const double width_px = filter.width_px(), total = integral(entry, width_px, [](double) { return 1; });
    constexpr int steps = 4096;
    double cumulative = 0, before = -width_px / 2;
    for (int i = 0; i < steps; ++i) {
      const double x = filter.offset_px((i + 1.0) / steps * (1 - 1e-12));
      EXPECT_GE(x, before) << entry.name;
      // The midpoint of two neighbours carries the share of one step.
      if (i > 8 && i + 8 < steps) {
        EXPECT_NEAR(filter.density((x + before) / 2) * (x - before) * steps, 1, 5e-3) << entry.name << ' ' << i;
      }
      cumulative += 1.0 / steps;
      before = x;
    }
    EXPECT_NEAR(cumulative, 1, 1e-12);
    for (const double t : {-0.9, -0.31, 0.0, 0.5, 0.77})
      EXPECT_NEAR(filter.density(t * width_px / 2), entry.shape(t) / total, 2e-4) << entry.name << ' ' << t;
    EXPECT_EQ(filter.density(width_px * 0.5001), 0);
  }
}

TEST(PixelFilter, ends_and_middle) {
  for (const FilterEntry& entry : pixel_filters) {
    const PixelFilter filter(entry.kind);
    EXPECT_NEAR(filter.offset_px(0), -filter.width_px() / 2, 1e-12) << entry.name;
    EXPECT_NEAR(filter.offset_px(0.5), 0, 1e-12) << entry.name;
    const double last = filter.offset_px(1 - 0x1p-24);
    EXPECT_LE(last, filter.width_px() / 2) << entry.name;
    EXPECT_GT(last, filter.width_px() / 2 * 0.93) << entry.name;
    for (const double u : {0.01, 0.2, 0.49})
      EXPECT_NEAR(filter.offset_px(u), -filter.offset_px(1 - u), 1e-11) << entry.name;
  }
}

TEST(PixelFilter, only_a_box_of_one_pixel_is_the_pixel) {
  EXPECT_TRUE(PixelFilter().is_the_pixel());
  for (const FilterEntry& entry : pixel_filters) {
    EXPECT_EQ(PixelFilter(entry.kind, 1).is_the_pixel(), entry.kind == FilterKind::box);
    EXPECT_FALSE(PixelFilter(entry.kind, 1.5).is_the_pixel());
  }
  const PixelFilter one, same(FilterKind::box, 1);
  for (const double u : {0.0, 0.25, 0.7, 0.999}) EXPECT_NEAR(one.offset_px(u), same.offset_px(u), 1e-15);
  EXPECT_EQ(one.density(0.3), 1);
}

TEST(PixelFilter, scenes_name_every_filter) {
  for (const FilterEntry& entry : pixel_filters) {
    SceneDesc description;
    description.image.pixel_filter = entry.name;
    const auto scene = compile(description, Resources{});
    ASSERT_TRUE(scene.ok()) << entry.name;
    EXPECT_EQ(scene->filter.kind(), entry.kind);
    EXPECT_EQ(scene->filter.width_px(), entry.default_width_px);
    description.image.filter_width_px = 2.5;
    EXPECT_EQ(compile(description, Resources{})->filter.width_px(), 2.5);
  }
}

// The table of keys tells the widths of the list.
TEST(PixelFilter, the_table_tells_the_widths) {
  std::string widths;
  for (const FilterEntry& entry : pixel_filters)
    widths += (widths.empty() ? "" : ", ") + std::string(entry.name) + " " + format_number(entry.default_width_px);
  const Key* key = mapping_of<ImageDesc>().find("filter_width_px");
  ASSERT_NE(key, nullptr);
  EXPECT_EQ(key->initial, widths);
  const Mapping& camera = mapping_of<CameraDesc>();
  EXPECT_EQ(camera.find("vertical_fov_deg")->initial, format_number(default_vertical_fov_deg));
  EXPECT_EQ(camera.find("orthographic_height")->initial, format_number(default_orthographic_height));
}

}  // namespace
}  // namespace shabon::scene
