// Directions towards lamps: densities that integrate to one, means that are the integrals of the light.
#include "shabon/render/lamp_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/render/base_brightness.h"
#include "tests/unit/render/sampling_checks.h"

namespace shabon::render {
namespace {

std::vector<double> odd_table(int width, int height) {
  std::vector<double> brightness;
  for (int i = 0; i < width * height; ++i) brightness.push_back((i * 37 % 11) * (i % 3 == 0 ? 0.0 : 1.0));
  brightness[static_cast<std::size_t>(width * height / 2 + 3)] = 500;
  return brightness;
}

TEST(DirectionTable, IsADensityThatSamplesFollow) {
  constexpr int width = 12, height = 7, count = 200'000;
  const std::vector<double> brightness = odd_table(width, height);
  const DirectionTable table(width, height, brightness);
  EXPECT_NEAR(over_all_directions(width * 8, height * 8, [&](const Vec3d& d) { return table.pdf(d); }), 1, 2e-3);
  std::vector<double> found(brightness.size());
  Chance chance;
  for (int i = 0; i < count; ++i) {
    const Vec3d d = table.sample(chance(), chance());
    ASSERT_NEAR(math::length(d), 1, 1e-12);
    const int column = static_cast<int>((0.5 + std::atan2(d.x, -d.z) / (2 * pi)) * width);
    const int row = static_cast<int>(std::acos(d.y) / pi * height);
    found[static_cast<std::size_t>(std::min(row, height - 1) * width + std::min(column, width - 1))] += 1;
  }
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const auto cell = static_cast<std::size_t>(row * width + column);
      const double density = table.pdf(direction_of((column + 0.5) / width, (row + 0.5) / height));
      const double expected = count * density * cell_solid_angle(width, height, row);
      if (brightness[cell] == 0) {
        EXPECT_EQ(found[cell], 0);
      }
      EXPECT_NEAR(found[cell], expected, errors_allowed * std::sqrt(expected) + 1e-9) << row << " " << column;
    }
}

// Chosen within a cell uniformly by solid angle: the mean of y is that of the cell.
TEST(DirectionTable, IsUniformWithinACell) {
  const DirectionTable table(1, 2, {1, 0});  // the upper half
  Mean y, y2;
  Chance chance;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3d d = table.sample(chance(), chance());
    y.add(d.y);
    y2.add(d.y * d.y);
  }
  EXPECT_NEAR(y.value(), 0.5, errors_allowed * y.error());
  EXPECT_NEAR(y2.value(), 1.0 / 3, errors_allowed * y2.error());
}

scene::ImageLight picture_light(int width, int height, double rotation_turns) {
  auto picture = std::make_shared<scene::EnvironmentPicture>();
  picture->width = width;
  picture->height = height;
  picture->texels.resize(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height) * 4);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column <= width; ++column)
      for (int c = 0; c < 3; ++c) {
        const int x = column % width;
        const bool window = x == width / 3 && row == height / 3;
        picture->texels[static_cast<std::size_t>(4 * (row * (width + 1) + column) + c)] =
            window ? 900.0f : static_cast<float>((x * 5 + row * 3 + c) % 7) * 0.1f;
      }
  scene::ImageLight light;
  light.picture = picture;
  light.rotation_turns = rotation_turns;
  light.scale = 1.5;
  return light;
}

struct EnvironmentCase {
  std::string name;
  scene::Environment environment;
  double quadrature_error;  // relative, of the grid that integrates it
};

scene::Environment sky(double elevation_deg, bool sun) {
  const scene::SkyAndSun made = scene::sky_and_sun({elevation_deg, 30, 3, 1, sun}, 0);
  scene::Environment environment{made.channels, made.sky, {}};
  if (made.sun) environment.softboxes.push_back(*made.sun);
  return environment;
}

// At least one of every base light and every softbox.
std::vector<EnvironmentCase> environment_cases() {
  std::vector<EnvironmentCase> cases;
  cases.push_back({"constant", with_base(scene::ConstantLight{0, 0.7}), 1e-4});
  cases.push_back({"gradient", with_base(scene::GradientLight{0, 1, 2.0, 0.1}), 1e-4});
  cases.push_back({"picture", with_base(picture_light(60, 40, 0.13)), 1e-2});
  cases.push_back({"small picture", with_base(picture_light(3, 2, 0)), 1e-2});
  cases.push_back({"sky", sky(35, false), 1e-3});
  const Vec3d towards{0.3, 0.8, -0.4};
  scene::Environment softboxes = with_base(scene::ConstantLight{0, 0});
  softboxes.softboxes = {scene::round_softbox(towards, 0.3, 1, 12)};
  cases.push_back({"round softbox", softboxes, 1e-2});
  softboxes.softboxes = {scene::window_softbox(towards, 0.9, 0.4, 0.5, 2, 3)};
  cases.push_back({"window", softboxes, 1e-2});
  softboxes.base = scene::GradientLight{0, 1, 0.4, 0.1};
  softboxes.softboxes = {scene::round_softbox({0, 1, 0.1}, 0.2, 1, 12),
                         scene::window_softbox(towards, 2.4, 1.5, 0, 2, 3), scene::round_softbox(towards, 0.5, 0, 0),
                         scene::round_softbox({1, 0.2, 0}, 2.0, 0, 0.5)};
  cases.push_back({"all together", softboxes, 1e-2});
  return cases;
}

double luminance(const scene::Environment& environment, const Vec3d& direction) {
  static std::vector<double> coefficients;
  coefficients.assign(environment.channels.size(), 0);
  environment.coefficients<double>(direction, coefficients);
  double y = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    y += coefficients[k] * color::radiance_to_xyz(environment.channels[k]).y;
  return y;
}

// The same with Y of the channels at hand, for many directions.
std::function<double(const Vec3d&)> luminance_of(const scene::Environment& environment) {
  std::vector<double> channel_y;
  for (const auto& channel : environment.channels) channel_y.push_back(color::radiance_to_xyz(channel).y);
  return [&environment, channel_y](const Vec3d& direction) {
    std::vector<double> coefficients(channel_y.size());
    environment.coefficients<double>(direction, coefficients);
    double y = 0;
    for (std::size_t k = 0; k < channel_y.size(); ++k) y += coefficients[k] * channel_y[k];
    return y;
  };
}

TEST(LampSampling, EnvironmentCasesCoverTheList) {
  std::set<std::size_t> bases, softboxes;
  for (const EnvironmentCase& one : environment_cases()) {
    bases.insert(one.environment.base.index());
    for (const scene::Softbox& softbox : one.environment.softboxes) softboxes.insert(softbox.index());
  }
  EXPECT_EQ(bases.size(), std::variant_size_v<scene::BaseLight>);
  EXPECT_EQ(softboxes.size(), std::variant_size_v<scene::Softbox>);
}

TEST(LampSampling, MeansOverDirectionsAreTheIntegralsOfTheLight) {
  for (const EnvironmentCase& one : environment_cases()) {
    SCOPED_TRACE(one.name);
    scene::Scene scene;
    scene.environment = one.environment;
    const LampSampling lamps(scene);
    ASSERT_TRUE(lamps.has_lamps());
    const Vec3d point{3, -1, 2};
    EXPECT_NEAR(over_all_directions(900, 450, [&](const Vec3d& d) { return lamps.pdf_infinity(point, d); }), 1, 2e-2);
    const auto light = luminance_of(one.environment);
    for (const Vec3d& normal : normals) {
      const double expected = over_all_directions(
          1200, 600, [&](const Vec3d& d) { return light(d) * std::max(0.0, math::dot(d, normal)); });
      Mean mean, whole;
      Chance chance;
      for (int i = 0; i < 20'000; ++i) {
        const auto found = lamps.sample(point, chance(), chance(), chance());
        ASSERT_TRUE(found);
        ASSERT_EQ(found->object, -1);
        ASSERT_TRUE(std::isinf(found->distance));
        ASSERT_NEAR(math::length(found->direction), 1, 1e-12);
        ASSERT_EQ(found->pdf, lamps.pdf_infinity(point, found->direction));
        whole.add(light(found->direction) / found->pdf);
        mean.add(light(found->direction) * std::max(0.0, math::dot(found->direction, normal)) / found->pdf);
      }
      EXPECT_NEAR(mean.value(), expected, errors_allowed * mean.error() + one.quadrature_error * expected);
      // Chosen by brightness: the light without the cosine hardly varies.
      EXPECT_LT(whole.error() * std::sqrt(whole.count), 0.5 * whole.value());
    }
  }
}

// The sun is too small for a grid: its share is its radiance over its solid angle.
TEST(LampSampling, FindsTheSun) {
  scene::Scene scene, without;
  scene.environment = sky(35, true);
  without.environment = sky(35, false);
  const LampSampling lamps(scene);
  const auto light = luminance_of(scene.environment), sky_light = luminance_of(without.environment);
  const auto& sun = std::get<scene::RoundSoftbox>(scene.environment.softboxes.front());
  const double expected =
      over_all_directions(1200, 600, [&](const Vec3d& d) { return sky_light(d) * std::max(0.0, d.y); }) +
      sun.scale * 2 * pi * (1 - sun.cos_half_angle) * sun.axis.y;
  Mean mean;
  Chance chance;
  for (int i = 0; i < 100'000; ++i) {
    const auto found = lamps.sample({}, chance(), chance(), chance());
    ASSERT_TRUE(found);
    mean.add(light(found->direction) * std::max(0.0, found->direction.y) / found->pdf);
  }
  EXPECT_NEAR(mean.value(), expected, errors_allowed * mean.error() + 1e-3 * expected);
  EXPECT_NEAR(mean.value(), pi, 0.02 * pi);  // a white card has Y = 1
}

TEST(LampSampling, PicturesOfAnySizeAreAveragedOverCells) {
  for (const auto& [width, height, rotation] :
       {std::tuple{3, 2, 0.2}, {64, 32, 0.0}, {100, 77, -0.31}, {2500, 40, 0.5}, {5000, 1100, 1.77}}) {
    SCOPED_TRACE(width);
    const scene::Environment environment = with_base(picture_light(width, height, rotation));
    const BaseBrightness grid = base_brightness(environment, {1, 1, 1});
    ASSERT_EQ(grid.brightness.size(), static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
    const double floor = 0.02 * grid.irradiance / (4 * pi);
    const int looks = 24;
    for (int cell = 5; cell < grid.width * grid.height; cell += grid.width * grid.height / 23) {
      const int row = cell / grid.width, column = cell % grid.width;
      double mean = 0;
      for (int i = 0; i < looks; ++i)
        for (int j = 0; j < looks; ++j) {
          double sum[3] = {};
          std::get<scene::ImageLight>(environment.base)
              .add(direction_of((column + (i + 0.5) / looks) / grid.width, (row + (j + 0.5) / looks) / grid.height),
                   sum);
          mean += (sum[0] + sum[1] + sum[2]) / (looks * looks);
        }
      EXPECT_NEAR(grid.brightness[static_cast<std::size_t>(cell)], mean + floor, 5e-3 * (mean + 0.1)) << cell;
    }
    // The bright texel is in some cell: the brightest one.
    EXPECT_GT(*std::max_element(grid.brightness.begin(), grid.brightness.end()), 100);
  }
}

TEST(LampSampling, WithoutLightThereIsNothingToFind) {
  scene::Scene scene;
  scene.environment = with_base(scene::ConstantLight{0, 0});
  scene.environment.softboxes = {scene::round_softbox({0, 1, 0}, 0.2, 1, 0)};
  const LampSampling lamps(scene);
  EXPECT_FALSE(lamps.has_lamps());
  EXPECT_FALSE(lamps.sample({}, 0.3, 0.2, 0.1));
  EXPECT_EQ(lamps.pdf_infinity({}, {0, 1, 0}), 0);
  EXPECT_EQ(luminance(scene.environment, {0, 1, 0}), 0);
}

}  // namespace
}  // namespace shabon::render
