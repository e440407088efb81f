// White furnaces: what keeps all light cannot be seen in a light that is the same from everywhere, and nothing makes
// light; and the split tree and the single path come to the same mean.

#include <gtest/gtest.h>

#include <cmath>

#include "shabon/optics/stack_expression.h"
#include "shabon/render/comb.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "tests/statistical/surface_cases.h"

namespace shabon {
namespace {

using testing_surfaces::SurfaceCase;

constexpr int side = 8;

struct Mean {
  double y = 0, error = 0;
};

// The mean Y over the picture, and its standard error from renders with different seeds.
Mean mean_of(scene::Scene scene, int renders) {
  double sum = 0, squares = 0;
  for (int k = 0; k < renders; ++k) {
    scene.render.seed = static_cast<std::uint64_t>(k + 1);
    render::Sensor sensor(scene.width, scene.height);
    const auto report = render::render(scene, {}, sensor);
    EXPECT_TRUE(report && report->dropped_samples == 0);
    double y = 0;
    for (int i = 0; i < scene.width * scene.height; ++i) y += sensor.mean(i % scene.width, i / scene.width).y;
    y /= scene.width * scene.height;
    sum += y, squares += y * y;
  }
  const double mean = sum / renders;
  return {mean, std::sqrt(std::max(0.0, squares / renders - mean * mean) / (renders - 1))};
}

scene::Scene furnace(const SurfaceCase& each, bool sphere) {
  scene::Scene scene = testing_surfaces::lit_from_everywhere(side, side, 20);
  const int surface = each.add(scene);
  if (sphere)
    testing_surfaces::add_object(scene, geometry::SphereCap{}, geometry::placement({0, 0, 0}), surface);
  else
    testing_surfaces::add_object(scene, geometry::Quad{}, geometry::placement({0, 0, 0}, {20, 50, 0}, {9, 9, 1}),
                                 surface);
  scene.render.samples = 64;
  return scene;
}

class Furnace : public ::testing::TestWithParam<SurfaceCase> {};

TEST(SurfaceCases, CoverTheList) {
  for (const bool covered : testing_surfaces::kinds_covered()) EXPECT_TRUE(covered);
}

TEST_P(Furnace, KeepsItsLight) {
  for (const bool sphere : {false, true}) {
    if (!sphere && GetParam().solid) continue;
    const Mean mean = mean_of(furnace(GetParam(), sphere), 5);
    std::printf("%-26s %-6s Y = %.6f +- %.6f\n", GetParam().name.c_str(), sphere ? "sphere" : "quad", mean.y,
                mean.error);
    EXPECT_LT(mean.y, 1 + 5 * mean.error + 2e-4);
    if (!GetParam().keeps_light) continue;
    EXPECT_GT(mean.y, 1 - GetParam().may_lose - 5 * mean.error - 2e-4);
  }
}

TEST_P(Furnace, TreeAndPathAgree) {
  scene::Scene scene = furnace(GetParam(), true);
  // A light that is not the same from everywhere.
  scene.environment.base = scene::GradientLight{0, 0, 1.0, 0.1};
  const Mean tree = mean_of(scene, 5);
  scene.render.transport = scene::Transport::path;
  scene.render.samples = 128;
  const Mean path = mean_of(scene, 5);
  EXPECT_LT(std::abs(tree.y - path.y), 5 * std::hypot(tree.error, path.error) + 1e-5) << tree.y << " " << path.y;
}

// Rough glass bends each wavelength its own way; what its facets lose is made up for at each. Rutile seen off its
// middle, where paths are trapped inside, at three wavelengths, each by all lanes of a comb.
TEST(WavelengthFurnace, RoughGlassKeepsItsLightAtEveryWavelength) {
  scene::Scene scene = testing_surfaces::lit_from_everywhere(1, 1, 1);
  scene::DielectricSurface rutile;
  rutile.coating.stack = *optics::parse_stack("air | TiO2-rutile");
  rutile.roughness.constant = 0.15;
  scene.surfaces.push_back(rutile);
  testing_surfaces::add_object(scene, geometry::SphereCap{}, geometry::placement({0, 0, 0}), 0);
  std::vector<double> nm;
  for (const double wavelength : {420.0, 550.0, 700.0}) nm.insert(nm.end(), render::lane_count, wavelength);
  const auto found = render::probe(scene, {{0.8, 0.1, 5}, {0, 0, -1}}, nm, {32768, 1});
  ASSERT_TRUE(found);
  for (std::size_t group = 0; group < nm.size(); group += render::lane_count) {
    double mean = 0, squares = 0;
    for (std::size_t i = group; i < group + render::lane_count; ++i) {
      const auto at = static_cast<std::size_t>(nm[i] - color::first_nm);
      const double light = scene.environment.channels[0][at];
      mean += found->radiance[i] / light / render::lane_count;
      squares += std::pow(found->standard_error[i] / light / render::lane_count, 2);
    }
    std::printf("%g nm: %.4f +- %.4f\n", nm[group], mean, std::sqrt(squares));
    EXPECT_NEAR(mean, 1, 0.01 + 4 * std::sqrt(squares)) << nm[group];
  }
}

// Boundaries of many indices, from either side: nothing of a table may go wrong at one of them alone.
TEST(IndexFurnace, RoughBoundariesKeepTheirLightAtEveryIndex) {
  for (const char* stack : {"air | 1.05", "air | 1.6", "air | MgF2 99nm | 1.6", "air | 1.69", "1.2 | 1.6", "1.5 | 2.4",
                            "1.5 | 1.0", "1.5 | air", "air | 1.62", "2.4 | 1.33"}) {
    scene::Scene scene = testing_surfaces::lit_from_everywhere(1, 1, 1);
    scene::DielectricSurface boundary;
    boundary.coating.stack = *optics::parse_stack(stack);
    boundary.roughness.constant = 0.3;
    scene.surfaces.push_back(boundary);
    testing_surfaces::add_object(scene, geometry::SphereCap{}, geometry::placement({0, 0, 0}), 0);
    scene.medium = boundary.coating.stack.incidence;
    const auto found = render::probe(scene, {{0.3, 0.2, 5}, {0, 0, -1}}, std::vector<double>{550.0}, {4096, 1});
    ASSERT_TRUE(found) << stack;
    const double light = scene.environment.channels[0][std::size_t(550 - color::first_nm)];
    EXPECT_NEAR(found->radiance[0] / light, 1, 0.02 + 5 * found->standard_error[0] / light) << stack;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Furnace, ::testing::ValuesIn(testing_surfaces::surface_cases()),
                         [](const auto& tested) { return testing_surfaces::test_name(tested.param); });

}  // namespace
}  // namespace shabon
