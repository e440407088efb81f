#include "shabon/scene/scene_file.h"

#include <gtest/gtest.h>

#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

// The example of the format, every key in use.
constexpr std::string_view whole_example = R"(shabon: 1
image: {width: 320, height: 200}
camera: {position: [1, 2, 5], look_at: [0, 0.5, 0], up: [0, 1, 0.1], vertical_fov_deg: 45, polarizer_deg: 90}
render: {samples: 16, interference: two-beam, seed: 7, split_threshold: 0.01, max_depth: 12}
environment:
  gradient: {up: {illuminant: D65, scale: 1}, down: {illuminant: a, scale: 0.1}}
  softboxes:
    - {direction: [1, 1, 1], half_angle_deg: 12, illuminant: D65, scale: 20}
    - {direction: [-1, 1, 1], width_deg: 40, height_deg: 30, roll_deg: -5, illuminant: E, scale: 10}
objects:
  - bubble:
      center: [0.5, 0, -1]
      radius: 1.5
      film:
        medium: 1.33+0.01i
        thickness: {linear: {top_nm: 150, bottom_nm: 900}}
  - bubble:
      film: {stack: "air | water 300nm | air"}
)";

SceneDesc read(std::string_view text) {
  const Result<SceneDesc> scene = read_scene(text, "test.yaml");
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
  return scene ? *scene : SceneDesc{};
}

TEST(ReadScene, takes_every_key_over) {
  const SceneDesc scene = read(whole_example);
  EXPECT_EQ(scene.image.width, 320);
  EXPECT_EQ(scene.image.height, 200);
  EXPECT_EQ(scene.camera.position, (math::Vec3d{1, 2, 5}));
  EXPECT_EQ(scene.camera.look_at, (math::Vec3d{0, 0.5, 0}));
  EXPECT_EQ(scene.camera.up, (math::Vec3d{0, 1, 0.1}));
  EXPECT_EQ(scene.camera.vertical_fov_deg, 45);
  EXPECT_EQ(scene.camera.polarizer_deg, 90);
  EXPECT_EQ(scene.render.samples, 16);
  EXPECT_EQ(scene.render.interference, optics::Interference::two_beam);
  EXPECT_EQ(scene.render.seed, 7u);
  EXPECT_EQ(scene.render.split_threshold, 0.01);
  EXPECT_EQ(scene.render.max_depth, 12);
  const auto& gradient = std::get<GradientEnvironmentDesc>(scene.environment.base);
  EXPECT_EQ(gradient.up.illuminant, "D65");
  EXPECT_EQ(gradient.down.illuminant, "a");
  EXPECT_EQ(gradient.down.scale, 0.1);
  ASSERT_EQ(scene.environment.softboxes.size(), 2u);
  EXPECT_EQ(std::get<RoundShapeDesc>(scene.environment.softboxes[0].shape).half_angle_deg, 12);
  EXPECT_EQ(scene.environment.softboxes[0].scale, 20);
  const auto& window = std::get<WindowShapeDesc>(scene.environment.softboxes[1].shape);
  EXPECT_EQ(window.width_deg, 40);
  EXPECT_EQ(window.height_deg, 30);
  EXPECT_EQ(window.roll_deg, -5);
  EXPECT_EQ(scene.environment.softboxes[1].illuminant, "E");
  EXPECT_EQ(scene.environment.softboxes[1].direction, (math::Vec3d{-1, 1, 1}));
  ASSERT_EQ(scene.objects.size(), 2u);
  const auto& first = std::get<BubbleDesc>(scene.objects[0]);
  EXPECT_EQ(first.center, (math::Vec3d{0.5, 0, -1}));
  EXPECT_EQ(first.radius, 1.5);
  const auto& film = std::get<MediumFilmDesc>(first.film);
  EXPECT_EQ(film.medium, "1.33+0.01i");
  EXPECT_EQ(std::get<film::LinearThickness>(film.thickness).top_nm, 150);
  EXPECT_EQ(std::get<film::LinearThickness>(film.thickness).bottom_nm, 900);
  EXPECT_EQ(std::get<StackFilmDesc>(std::get<BubbleDesc>(scene.objects[1]).film).stack, "air | water 300nm | air");
}

TEST(ReadScene, leaves_the_rest_at_its_defaults) {
  const SceneDesc scene = read("{shabon: 1, environment: {constant: {}}}");
  const SceneDesc defaults;
  EXPECT_EQ(scene.image.width, defaults.image.width);
  EXPECT_EQ(scene.camera.position, defaults.camera.position);
  EXPECT_FALSE(scene.camera.polarizer_deg);
  EXPECT_EQ(scene.render.samples, defaults.render.samples);
  EXPECT_EQ(scene.render.split_threshold, 1e-3);
  EXPECT_EQ(scene.render.max_depth, 64);
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_EQ(std::get<ConstantEnvironmentDesc>(scene.environment.base).illuminant, "D65");
}

TEST(ReadScene, takes_json_and_whole_numbers_with_a_point) {
  const SceneDesc scene = read(R"({"shabon": 1.0, "image": {"width": 1e2, "height": 64.0},
                                   "environment": {"constant": {"illuminant": "D65"}}})");
  EXPECT_EQ(scene.image.width, 100);
  EXPECT_EQ(scene.image.height, 64);
}

TEST(ReadScene, keeps_large_seeds_exact) {
  EXPECT_EQ(read("{shabon: 1, render: {seed: 9223372036854775807}, environment: {constant: {}}}").render.seed,
            9223372036854775807u);
}

TEST(ReadScene, repeats_what_an_alias_names) {
  const SceneDesc scene = read(R"(shabon: 1
environment: {constant: {}}
objects:
  - bubble: {radius: 1, film: &soap {medium: water, thickness: {constant_nm: 123}}}
  - bubble: {radius: 2, film: *soap}
)");
  const auto& film = std::get<MediumFilmDesc>(std::get<BubbleDesc>(scene.objects[1]).film);
  EXPECT_EQ(std::get<film::ConstantThickness>(film.thickness).constant_nm, 123);
}

TEST(ReadScene, names_the_place_of_the_contract) {
  const Result<SceneDesc> scene = read_scene(R"(shabon: 1
environment:
  constant: {illuminant: D65}
objects:
  - bubble:
      film:
        medium: water
        thickness:
          linear:
            bottom_nm: 900
            top_nm: -120
)",
                                             "scene.yaml");
  ASSERT_FALSE(scene.ok());
  ASSERT_EQ(scene.errors().size(), 1u);
  EXPECT_EQ(to_text(scene.errors()[0]),
            "scene.yaml:11:21: error: objects[0].bubble.film.thickness.linear.top_nm: expected >= 0 nm, got -120\n"
            "                top_nm: -120\n"
            "                        ^");
  EXPECT_EQ(scene.errors()[0].failure, Failure::content);
}

TEST(ReadScene, reports_in_the_order_of_the_file) {
  const Result<SceneDesc> scene = read_scene(R"(shabon: 1
objects: [{bubble: {radius: 0}}]
camera: {up: [0, 0, 0]}
render: {samples: none}
environment: {constant: {illuminant: x, scale: -1}}
)",
                                             "scene.yaml");
  ASSERT_FALSE(scene.ok());
  int line = 0, column = 0;
  for (const Diagnostic& error : scene.errors()) {
    EXPECT_TRUE(error.line > line || (error.line == line && error.column >= column)) << to_text(error);
    line = error.line, column = error.column;
  }
  EXPECT_EQ(scene.errors().size(), 6u) << to_text(scene.errors());
}

}  // namespace
}  // namespace shabon::scene
