#include "shabon/scene/override.h"

#include <gtest/gtest.h>

#include "shabon/scene/scene_file.h"

namespace shabon::scene {
namespace {

constexpr std::string_view file = R"(shabon: 1
camera: {position: [0, 0, 5]}
environment:
  gradient: {up: {scale: 2}, down: {scale: 1}}
objects:
  - bubble: {radius: 1, film: {medium: water, thickness: {linear: {top_nm: 100, bottom_nm: 200}}}}
)";

SceneDesc read_with(const std::vector<std::string>& assignments) {
  Result<io::YamlDocument> document = io::parse_yaml(file, "scene.yaml");
  for (const std::string& assignment : assignments) {
    const Status set = apply_override(*document, assignment);
    EXPECT_TRUE(set.ok()) << to_text(set.errors());
  }
  const Result<SceneDesc> scene = read_scene(*std::move(document));
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
  return scene ? *scene : SceneDesc{};
}

const BubbleDesc& bubble(const SceneDesc& scene) { return std::get<BubbleDesc>(scene.objects.at(0)); }

TEST(Override, replaces_a_value) { EXPECT_EQ(bubble(read_with({"objects[0].bubble.radius=2"})).radius, 2); }

TEST(Override, the_last_one_counts) {
  EXPECT_EQ(
      bubble(read_with({"objects[0].bubble.radius=2", "objects[0].bubble.radius=-0", "objects[0].bubble.radius=3"}))
          .radius,
      3);
}

TEST(Override, replaces_one_component) {
  EXPECT_EQ(read_with({"camera.position[1]=-.5"}).camera.position, (math::Vec3d{0, -0.5, 5}));
}

TEST(Override, replaces_lists_and_mappings) {
  EXPECT_EQ(read_with({"camera.position=[1, 2, 3]"}).camera.position, (math::Vec3d{1, 2, 3}));
  EXPECT_EQ(read_with({"camera={vertical_fov_deg: 50}"}).camera.vertical_fov_deg, 50);
}

TEST(Override, adds_what_the_file_leaves_out) {
  const SceneDesc scene = read_with({"render.samples=3", "camera.polarizer_deg=45", "objects[0].bubble.center=[1,0,0]",
                                     "environment.softboxes=[{direction: [0, 1, 0], half_angle_deg: 5}]",
                                     "environment.softboxes[0].scale=7"});
  EXPECT_EQ(scene.render.samples, 3);
  EXPECT_EQ(scene.camera.polarizer_deg, 45);
  EXPECT_EQ(bubble(scene).center, (math::Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.environment.softboxes.at(0).scale, 7);
}

TEST(Override, one_choice_replaces_another) {
  const SceneDesc scene =
      read_with({"environment.constant.scale=3", "objects[0].bubble.film.thickness.constant_nm=70"});
  EXPECT_EQ(std::get<ConstantEnvironmentDesc>(scene.environment.base).scale, 3);
  const auto& film = std::get<MediumFilmDesc>(bubble(scene).film);
  EXPECT_EQ(std::get<film::ConstantThickness>(film.thickness).constant_nm, 70);
  const SceneDesc stack = read_with({"objects[0].bubble.film.stack=air | 1.5 20nm | air"});
  EXPECT_EQ(std::get<StackFilmDesc>(bubble(stack).film).stack, "air | 1.5 20nm | air");
}

TEST(Override, takes_a_color_without_quotes) {
  const SceneDesc scene =
      read_with({"objects=[{quad: {surface: {diffuse: {}}}}]", "objects[0].quad.surface.diffuse.color= #ff8000 "});
  const auto& quad = std::get<QuadDesc>(scene.objects.at(0));
  EXPECT_EQ(std::get<DiffuseSurfaceDesc>(quad.surface.chosen).color, (ColorDesc{"#ff8000"}));
}

TEST(Override, takes_equals_signs_and_spaces_in_the_value) {
  const Status set = [] {
    Result<io::YamlDocument> document = io::parse_yaml(file, "scene.yaml");
    return apply_override(*document, " objects[0].bubble.film.medium = file:a=b.csv");
  }();
  EXPECT_TRUE(set.ok());
}

TEST(Override, leaves_the_document_alone_when_it_fails) {
  Result<io::YamlDocument> document = io::parse_yaml(file, "scene.yaml");
  ASSERT_FALSE(apply_override(*document, "environment.constant.sacle=3").ok());
  const Result<SceneDesc> scene = read_scene(*std::move(document));
  ASSERT_TRUE(scene.ok());
  EXPECT_TRUE(std::holds_alternative<GradientEnvironmentDesc>(scene->environment.base));
}

TEST(Override, says_which_kind_of_failure_it_is) {
  Result<io::YamlDocument> document = io::parse_yaml(file, "scene.yaml");
  EXPECT_EQ(apply_override(*document, "radius").errors()[0].failure, Failure::usage);
  EXPECT_EQ(apply_override(*document, "render.sample=3").errors()[0].failure, Failure::content);
}

}  // namespace
}  // namespace shabon::scene
