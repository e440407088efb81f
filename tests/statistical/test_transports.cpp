// Every scene of the gallery by the split tree, by the single path, and for bubbles so by both kernels: the same means.
// Small pictures of several seeds, compared by blocks of pixels and as a whole.
#include <gtest/gtest.h>

#include <cctype>
#include <iostream>
#include <set>

#include "shabon/api/shabon.h"
#include "tests/gallery_scene.h"
#include "tests/statistical/z_tests.h"

namespace shabon {
namespace {

constexpr int width = 32, block = 8;
constexpr int renders = 12;                        // of different seeds, by each transport
constexpr int samples = SHABON_TRANSPORT_SAMPLES;  // of each: a multiple of the 64 combs
constexpr double unavoidable = 1e-5;               // of the picture's mean: where chance makes no difference
constexpr const char* components[] = {"X", "Y", "Z"};

Result<scene::Scene> load(const std::string& name) {
  auto scene = test::gallery_scene(name, width);
  if (scene) scene->render.samples = samples;
  return scene;
}

// Means of blocks, and last of the whole picture: [place * 3 + component][render].
using Means = std::vector<std::vector<double>>;

Means means_of(scene::Scene scene, scene::Transport transport) {
  const int across = (scene.width + block - 1) / block, down = (scene.height + block - 1) / block;
  const auto places = static_cast<std::size_t>(across * down);
  Means means(3 * (places + 1));
  scene.render.transport = transport;
  for (int i = 0; i < renders; ++i) {
    scene.render.seed = static_cast<std::uint64_t>(2 * i + (transport == scene::Transport::path ? 1 : 0));
    render::Sensor sensor(scene.width, scene.height);
    const auto done = render::render(scene, {}, sensor);
    EXPECT_TRUE(done && done->dropped_samples == 0);
    std::vector<double> sums(3 * (places + 1)), pixels(places + 1);
    for (int y = 0; y < scene.height; ++y)
      for (int x = 0; x < scene.width; ++x) {
        const color::Xyz mean = sensor.mean(x, y);
        for (const std::size_t place : {static_cast<std::size_t>(y / block * across + x / block), places}) {
          sums[3 * place] += mean.x, sums[3 * place + 1] += mean.y, sums[3 * place + 2] += mean.z;
          pixels[place] += 1;
        }
      }
    for (std::size_t k = 0; k < sums.size(); ++k) means[k].push_back(sums[k] / pixels[k / 3]);
  }
  return means;
}

class Transports : public testing::TestWithParam<std::string> {};

TEST_P(Transports, TreeAndPathComeToTheSame) {
  const auto scene = load(GetParam());
  ASSERT_TRUE(scene) << to_text(scene.errors());
  const Means tree = means_of(*scene, scene::Transport::tree), path = means_of(*scene, scene::Transport::path);
  const double brightness = z_tests::estimate(tree[tree.size() - 2]).mean;
  ASSERT_GT(brightness, 0);
  z_tests::Differences differences;
  for (std::size_t k = 0; k < tree.size(); ++k)
    differences.add(
        "place " + std::to_string(k / 3) + " " + components[k % 3],
        z_tests::z_of_difference(z_tests::estimate(path[k]), z_tests::estimate(tree[k]), unavoidable * brightness));
  const auto error = [&](const Means& means) {
    const auto whole = z_tests::estimate(means[means.size() - 2]);
    return whole.error / whole.mean;
  };
  std::cout << GetParam() << ": " << differences.text() << "; relative errors of the picture's Y " << error(tree)
            << " and " << error(path) << '\n';
  EXPECT_TRUE(differences.agree()) << differences.text();
}

INSTANTIATE_TEST_SUITE_P(Scenes, Transports, testing::ValuesIn(test::gallery_names()), [](const auto& scene) {
  std::string name = scene.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

}  // namespace
}  // namespace shabon
