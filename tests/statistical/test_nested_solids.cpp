// Glass within glass within glass: light is split at every boundary, and a part of it stays inside for long. The mean
// must be right all the same, by any transport and wherever paths end, and the work bounded.
#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "shabon/render/probe.h"
#include "shabon/scene/compile.h"
#include "tests/statistical/z_tests.h"

namespace shabon {
namespace {

constexpr int shells = 10;
constexpr int probes = 16;  // of different seeds
constexpr std::size_t samples = 64;
constexpr double rounding = 2e-6;  // of float, after hundreds of surfaces

// Ball in ball, glass and air in turn, in the same light from everywhere or in one that comes from above.
scene::Scene nested(double index, const std::string& render, const std::string& light) {
  std::string text =
      "shabon: 1\nimage: {width: 64, height: 48}\nrender: {" + render + "}\nenvironment: {" + light + "}\nobjects:\n";
  const std::string glass = std::to_string(index);
  for (int i = 0; i < shells; ++i)
    text += "- sphere: {radius: " + std::to_string(1 - 0.08 * i) + ", surface: {dielectric: {stack: '" +
            (i % 2 == 0 ? "air | " + glass : glass + " | air") + "'}}}\n";
  auto scene = scene::load_scene(text, "nested", {}, {});
  EXPECT_TRUE(scene) << to_text(scene.errors());
  return *scene;
}

struct Probed {
  z_tests::Estimate radiance;
  double events_per_walk = 0;
};

Probed probed(const scene::Scene& scene, std::uint64_t first_seed = 1) {
  const double wavelength_nm[] = {550};
  std::vector<double> radiances;
  double events = 0;
  for (int i = 0; i < probes; ++i) {
    const auto result = render::probe(scene, render::pixel_ray(scene, 30.5, 20.5), wavelength_nm,
                                      {samples, first_seed + static_cast<std::uint64_t>(i)});
    EXPECT_TRUE(result);
    radiances.push_back(result->radiance.front());
    events += static_cast<double>(result->film_events);
  }
  return {z_tests::estimate(radiances), events / (probes * samples)};
}

const std::string even = "constant: {illuminant: E}";
const std::string uneven =
    "gradient: {up: {illuminant: E}, down: {illuminant: E, scale: 0.1}}, softboxes: [{direction: [1, 1, 1], "
    "half_angle_deg: 12, illuminant: E, scale: 20}]";

// Glass without loss is invisible in the same light from everywhere, (27) or not.
TEST(NestedSolids, NoLightIsLost) {
  scene::Scene empty = nested(2.4, "", even);
  empty.objects.clear();
  const double lamp = probed(empty).radiance.mean;
  z_tests::Differences differences;
  for (const double index : {1.5, 2.4})
    for (const char* render :
         {"", "max_depth: 12", "split_threshold: 0.1", "transport: path", "transport: path, max_depth: 12"}) {
      const Probed found = probed(nested(index, render, even));
      const std::string name = std::to_string(index) + " " + render;
      std::cout << name << ": " << found.radiance.mean / lamp << " +- " << found.radiance.error / lamp << ", "
                << found.events_per_walk << " events a walk\n";
      differences.add(name, z_tests::z_of_difference(found.radiance, {lamp, 0, 1e6}, rounding * lamp));
    }
  EXPECT_TRUE(differences.agree()) << differences.text();
}

TEST(NestedSolids, TreeAndPathComeToTheSame) {
  z_tests::Differences differences;
  for (const double index : {1.5, 2.4}) {
    const Probed tree = probed(nested(index, "", uneven)), path = probed(nested(index, "transport: path", uneven), 100);
    differences.add(std::to_string(index), z_tests::z_of_difference(path.radiance, tree.radiance, 0));
    EXPECT_LT(tree.radiance.error * 4, path.radiance.error) << index;
  }
  EXPECT_TRUE(differences.agree()) << differences.text();
}

// Boundaries at which each ray splits in two: the tree grows with their number, but not with its powers.
TEST(NestedSolids, TheWorkIsBounded) {
  EXPECT_LT(probed(nested(1.5, "", uneven)).events_per_walk, 1000);
  EXPECT_LT(probed(nested(2.4, "", uneven)).events_per_walk, 2000);
}

}  // namespace
}  // namespace shabon
