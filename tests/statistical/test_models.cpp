// Each model of interference by both kernels: the one for bubbles alone, and the one for surfaces, which a card behind
// the camera calls for. The same probes, and the same means of renders.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "shabon/optics/interference.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "shabon/scene/compile.h"
#include "tests/statistical/z_tests.h"

namespace shabon {
namespace {

constexpr int width = 24, height = 18, block = 6;
constexpr int renders = 10, samples = 64;  // of different seeds; a multiple of the 64 combs
constexpr double rounding = 2e-5;          // of float, of the brightest light

scene::Scene scene_with(std::string_view model, bool card, const std::string& camera = "") {
  std::string text =
      "shabon: 1\nimage: {width: " + std::to_string(width) + ", height: " + std::to_string(height) +
      "}\ncamera: {position: [0, 0.3, 4], vertical_fov_deg: 40" + camera +
      "}\nrender: {samples: " + std::to_string(samples) + ", interference: " + std::string(model) +
      "}\nenvironment:\n"
      "  gradient: {up: {illuminant: D65, scale: 1}, down: {illuminant: A, scale: 0.2}}\n"
      "  softboxes: [{direction: [1, 1, 1], half_angle_deg: 20, illuminant: FL2, scale: 4}]\n"
      "objects:\n"
      "- bubble: {film: {medium: soap, thickness: {linear: {top_nm: 100, bottom_nm: 700}}}}\n"
      "- bubble: {center: [0.5, 0.2, 0.2], radius: 0.4, film: {medium: 1.5, thickness: {constant_nm: 350}}}\n";
  if (card) text += "- quad: {position: [0, 0, 900], surface: {diffuse: {color: 0.5}}}\n";
  auto scene = scene::load_scene(text, "models", {}, {});
  EXPECT_TRUE(scene) << to_text(scene.errors());
  return *scene;
}

class Models : public testing::TestWithParam<const char*> {};

// Without chance, but for branches that carry next to nothing.
TEST_P(Models, ProbesAgree) {
  for (const char* camera : {"", ", polarizer_deg: 30"}) {
    const scene::Scene alone = scene_with(GetParam(), false, camera), with_card = scene_with(GetParam(), true, camera);
    const double wavelengths_nm[] = {400, 450, 500, 550, 600, 650, 700};
    z_tests::Differences differences;
    for (const double x : {8.3, 12.1, 14.9, 17.2})
      for (const double y : {4.4, 9.3, 12.8}) {
        const auto a = render::probe(alone, render::pixel_ray(alone, x, y), wavelengths_nm);
        const auto b = render::probe(with_card, render::pixel_ray(with_card, x, y), wavelengths_nm, {512, 1});
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(a->standard_error.empty());
        const double brightest = *std::max_element(a->radiance.begin(), a->radiance.end());
        for (std::size_t i = 0; i < a->radiance.size(); ++i)
          differences.add(std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(wavelengths_nm[i]),
                          z_tests::z_of_difference({b->radiance[i], b->standard_error[i], 15}, {a->radiance[i], 0, 1e6},
                                                   rounding * brightest));
      }
    std::cout << GetParam() << camera << ": " << differences.text() << '\n';
    EXPECT_TRUE(differences.agree()) << differences.text();
  }
}

// Y of blocks of pixels, by render.
std::vector<std::vector<double>> blocks_of(scene::Scene scene, std::uint64_t first_seed) {
  std::vector<std::vector<double>> result(std::size_t{width / block} * (height / block));
  for (int i = 0; i < renders; ++i) {
    scene.render.seed = first_seed + static_cast<std::uint64_t>(i);
    render::Sensor sensor(scene.width, scene.height);
    EXPECT_TRUE(render::render(scene, {}, sensor));
    std::vector<double> sums(result.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        sums[static_cast<std::size_t>(y / block * (width / block) + x / block)] += sensor.mean(x, y).y;
    for (std::size_t k = 0; k < sums.size(); ++k) result[k].push_back(sums[k] / (block * block));
  }
  return result;
}

TEST_P(Models, RendersAgree) {
  const auto alone = blocks_of(scene_with(GetParam(), false), 1),
             with_card = blocks_of(scene_with(GetParam(), true), 101);
  z_tests::Differences differences;
  for (std::size_t k = 0; k < alone.size(); ++k)
    differences.add("block " + std::to_string(k),
                    z_tests::z_of_difference(z_tests::estimate(with_card[k]), z_tests::estimate(alone[k]), rounding));
  std::cout << GetParam() << ": " << differences.text() << '\n';
  EXPECT_TRUE(differences.agree()) << differences.text();
}

std::vector<const char*> models() {
  std::vector<const char*> names;
  for (const auto& model : optics::interference_models) names.push_back(model.name.data());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Each, Models, testing::ValuesIn(models()), [](const auto& model) {
  std::string name = model.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace shabon
