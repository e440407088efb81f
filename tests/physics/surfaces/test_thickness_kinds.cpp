// One film, stated in several ways: a model, a picture, a cube. The renderer and the probe must see the same.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "shabon/scene/compile.h"

namespace shabon {
namespace {

scene::Scene scene_of(const std::string& object) {
  scene::Resources resources;
  resources.texture = [](const std::string&) -> Result<scene::TextureFile> {
    return scene::TextureFile{{4, 2, 1, std::vector<float>(8, 700.0f)}};
  };
  auto scene = scene::load_scene(
      "shabon: 1\nimage: {width: 40, height: 40}\ncamera: {position: [0, 0.5, 5], vertical_fov_deg: 30}\n"
      "render: {samples: 4}\nenvironment: {constant: {scale: 0.1}, softboxes: [{direction: [1, 1, 1], half_angle_deg: "
      "60, scale: 5}]}\nobjects:\n  - " +
          object + "\n",
      "test.yaml", {}, resources);
  if (!scene) throw std::invalid_argument(scene.errors().front().message);
  return *std::move(scene);
}

// The largest difference of any pixel's Y.
double difference(const scene::Scene& a, const scene::Scene& b) {
  render::Sensor one(a.width, a.height), other(a.width, a.height);
  EXPECT_TRUE(render::render(a, {}, one));
  EXPECT_TRUE(render::render(b, {}, other));
  double worst = 0, most = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      worst = std::max(worst, std::abs(one.mean(x, y).y - other.mean(x, y).y));
      most = std::max(most, one.mean(x, y).y);
    }
  EXPECT_GT(most, 0.3);  // something is seen
  return worst;
}

std::shared_ptr<const film::SphereMap> cube_of(const film::ThicknessField& field) {
  return std::make_shared<const film::SphereMap>(
      film::sphere_map(513, [&](const math::Vec3d& d) { return film::thickness_nm(field, d); }));
}

const std::string models[] = {"linear: {top_nm: 200, bottom_nm: 900}", "equilibrium: {mean_nm: 500, squeeze: 0.8}",
                              "rigid_drainage: {start_nm: 600, age_s: 3e4}",
                              "self_similar: {top_nm: 300, bottom_nm: 900, age_s: 4}",
                              "noise: {base: {linear: {top_nm: 200, bottom_nm: 900}}, octaves: 2, swirl: 0.3}"};

TEST(ThicknessKinds, a_bubble_with_the_cube_of_a_model_is_the_model) {
  for (const std::string& model : models) {
    const scene::Scene scene = scene_of("bubble: {film: {medium: water, thickness: {" + model + "}}}");
    scene::Scene cube = scene;
    cube.films[0].thickness = cube_of(scene.films[0].thickness);
    EXPECT_LT(difference(scene, cube), 3e-3) << model;
    const std::vector<double> wavelengths_nm = {450, 550, 650};
    const render::ProbeRay ray{{0, 0.2, 5}, {0.05, 0.02, -1}, false};
    const auto a = render::probe(scene, ray, wavelengths_nm, {16, 1}),
               b = render::probe(cube, ray, wavelengths_nm, {16, 1});
    ASSERT_TRUE(a && b);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a->radiance[i], b->radiance[i], 1e-3 * a->radiance[i]) << model;
  }
}

TEST(ThicknessKinds, pictures_of_one_value_are_the_constant) {
  for (const std::string shape : {"bubble: {film: {", "quad: {surface: {film: {", "sphere: {surface: {film: {"}) {
    const std::string end = shape.starts_with("bubble") ? "}}" : "}}}";
    const auto with = [&](const std::string& thickness) {
      return scene_of(shape + "medium: water, thickness: {" + thickness + "}" + end);
    };
    const scene::Scene constant = with("constant_nm: 700");
    EXPECT_LT(difference(constant, with("map: {file: nm.exr}")), 1e-5) << shape;
    EXPECT_GT(difference(constant, with("constant_nm: 400")), 0.02) << shape;
  }
}

}  // namespace
}  // namespace shabon
