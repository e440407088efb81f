#include "shabon/scene/compile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "shabon/color/illuminant.h"
#include "shabon/color/xyz.h"

namespace shabon::scene {
namespace {

using math::Vec3d;

BubbleDesc bubble(Vec3d center, double radius, double thickness_nm) {
  return {center, radius, MediumFilmDesc{"water", film::ConstantThickness{thickness_nm}}};
}

Scene compiled(const SceneDesc& description, const Resources& resources = {}) {
  const Result<Scene> scene = compile(description, resources);
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
  return scene ? *scene : Scene{};
}

std::string errors_of(const SceneDesc& description, const Resources& resources = {}) {
  const Result<Scene> scene = compile(description, resources);
  return scene ? "" : to_text(scene.errors());
}

std::vector<double> coefficients(const Scene& scene, Vec3d direction) {
  std::vector<double> result(scene.environment.channels.size());
  scene.environment.coefficients(direction, std::span(result));
  return result;
}

double luminance(const Scene& scene, Vec3d direction) {
  const std::vector<double> weights = coefficients(scene, math::normalize(direction));
  double y = 0;
  for (std::size_t c = 0; c < weights.size(); ++c)
    y += weights[c] * color::radiance_to_xyz(scene.environment.channels[c], color::observer_1931()).y;
  return y;
}

TEST(Compile, takes_a_description_written_in_code) {
  const Scene scene = compiled(SceneDesc{});
  EXPECT_EQ(scene.width, 800);
  EXPECT_EQ(scene.height, 600);
  EXPECT_TRUE(scene.spheres.empty());
  EXPECT_EQ(scene.medium, optics::Medium());
  EXPECT_NEAR(luminance(scene, {0, 1, 0}), 1, 1e-12);
}

TEST(Compile, checks_a_description_written_in_code) {
  SceneDesc description;
  description.camera.vertical_fov_deg = std::numeric_limits<double>::quiet_NaN();
  description.render.samples = 0;
  description.objects.push_back(bubble({0, 0, 0}, -1, std::numeric_limits<double>::infinity()));
  std::get<ConstantEnvironmentDesc>(description.environment.base).illuminant = "D66";
  EXPECT_EQ(errors_of(description),
            "error: camera.vertical_fov_deg: expected a finite number, got nan\n"
            "error: render.samples: expected >= 1, got 0\n"
            "error: environment.constant.illuminant: unknown illuminant 'D66'; did you mean 'D65'?\n"
            "error: objects[0].bubble.radius: expected > 0, got -1\n"
            "error: objects[0].bubble.film.thickness.constant_nm: expected a finite number, got inf\n");
}

TEST(Compile, joins_bubbles_that_coincide_in_the_order_of_objects) {
  SceneDesc description;
  description.objects = {bubble({0, 0, 0}, 1, 100), bubble({0, 0, 0}, 2, 200), bubble({-0.0, 0, 0}, 1, 300),
                         bubble({0, 0, 1}, 1, 400), bubble({0, 0, 0}, 1, 500)};
  const Scene scene = compiled(description);
  ASSERT_EQ(scene.spheres.size(), 3u);
  ASSERT_EQ(scene.films.size(), 5u);
  std::vector<double> order;
  for (const Sphere& sphere : scene.spheres)
    for (int i = 0; i < sphere.film_count; ++i)
      order.push_back(
          film::thickness_nm(scene.films[static_cast<std::size_t>(sphere.first_film + i)].thickness, Vec3d{0, 1, 0}));
  EXPECT_EQ(order, (std::vector<double>{100, 300, 500, 200, 400}));
  EXPECT_EQ(scene.spheres[0].film_count, 3);
}

TEST(Compile, reads_films_of_every_spelling_alike) {
  SceneDesc description;
  description.objects = {BubbleDesc{{0, 0, 0}, 1, MediumFilmDesc{"1.5", film::ConstantThickness{300}}},
                         BubbleDesc{{0, 0, 0}, 1, StackFilmDesc{"air | 1.5 0.3um | vacuum"}}};
  const Scene scene = compiled(description);
  EXPECT_EQ(scene.films[0].layers.front().medium, scene.films[1].layers.front().medium);
  EXPECT_DOUBLE_EQ(std::get<film::ConstantThickness>(scene.films[1].thickness).constant_nm, 300);
}

TEST(Compile, reads_stacks_with_the_thickness_of_one_layer) {
  const std::string stack = "air | 2.1 60nm | water 300nm | 1.46 90nm | air";
  SceneDesc description;
  description.objects = {
      BubbleDesc{{0, 0, 0}, 1, StackFilmDesc{stack}},
      BubbleDesc{{0, 0, 0}, 1, StackFilmDesc{stack, VariedLayerDesc{2, film::LinearThickness{150, 900}}}},
      BubbleDesc{
          {0, 0, 0}, 1, StackFilmDesc{"air | water 300nm | air", VariedLayerDesc{1, film::ConstantThickness{70}}}}};
  const Scene scene = compiled(description);
  ASSERT_EQ(scene.films.size(), 3u);
  EXPECT_EQ(scene.films[0].layers.size(), 3u);
  EXPECT_EQ(scene.films[0].varied_layer, 0u);
  EXPECT_EQ(std::get<film::ConstantThickness>(scene.films[0].thickness).constant_nm, 60);
  EXPECT_EQ(scene.films[1].layers, scene.films[0].layers);
  EXPECT_EQ(scene.films[1].varied_layer, 1u);
  EXPECT_EQ(std::get<film::LinearThickness>(scene.films[1].thickness).bottom_nm, 900);
  EXPECT_EQ(std::get<film::ConstantThickness>(scene.films[2].thickness).constant_nm, 70);
}

TEST(Compile, the_outer_medium_of_the_films_fills_the_scene) {
  SceneDesc description;
  description.objects = {BubbleDesc{{0, 0, 0}, 1, StackFilmDesc{"water | 1 300nm | WATER"}}};
  EXPECT_EQ(compiled(description).medium.name(), "water");
}

TEST(Compile, points_the_camera) {
  SceneDesc description;
  description.camera.position = {0, 0, 5};
  description.camera.vertical_fov_deg = 90;
  description.camera.polarizer_deg = 45;
  description.image = {200, 100};
  const Scene scene = compiled(description);
  const Vec3d middle = scene.camera.through(100.0, 50.0), corner = scene.camera.through(0.0, 0.0);
  EXPECT_NEAR(middle.x, 0, 1e-15);
  EXPECT_NEAR(middle.z, -1, 1e-15);
  EXPECT_NEAR(corner.x / -corner.z, -2, 1e-12);
  EXPECT_NEAR(corner.y / -corner.z, 1, 1e-12);
  EXPECT_NEAR(*scene.camera.polarizer_rad, std::numbers::pi / 4, 1e-15);
}

TEST(Compile, mixes_a_gradient_by_height) {
  SceneDesc description;
  description.environment.base = GradientEnvironmentDesc{{"D65", 3}, {"A", 1}};
  const Scene scene = compiled(description);
  EXPECT_EQ(scene.environment.channels.size(), 2u);
  EXPECT_NEAR(luminance(scene, {0, 1, 0}), 3, 1e-12);
  EXPECT_NEAR(luminance(scene, {0, -1, 0}), 1, 1e-12);
  EXPECT_NEAR(luminance(scene, {1, 0, 0}), 2, 1e-12);
}

TEST(Compile, gives_every_lamp_one_channel_whatever_its_spelling) {
  SceneDesc description;
  const char* spellings[] = {"FL11", "f11", "blackbody:2856K", "Blackbody: 2856", "file:mine.csv", "file:mine.csv"};
  for (const char* spelling : spellings) {
    SoftboxDesc softbox;
    softbox.illuminant = spelling;
    softbox.shape = RoundShapeDesc{10};
    softbox.scale = 2;
    description.environment.softboxes.push_back(softbox);
  }
  int read = 0;
  Resources resources;
  resources.illuminant = [&read](std::string_view text) -> Result<color::Illuminant> {
    if (!color::illuminant_file(text)) return color::illuminant_named(text);
    ++read;
    return color::illuminant_from_samples(std::string(text), "", std::array{300.0, 900.0}, std::array{0.0, 1.0});
  };
  const Result<Scene> scene = compile(description, resources);
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene->environment.channels.size(), 4u);  // those three and D65, the base
  EXPECT_EQ(read, 1);
  EXPECT_NEAR(luminance(*scene, {0, 1, 0}), 1 + 2 * std::size(spellings), 1e-11);
  const Result<Scene> without_files = compile(description, {});
  ASSERT_FALSE(without_files.ok());
  EXPECT_NE(to_text(without_files.errors()).find("no file can be read here"), std::string::npos);
}

TEST(Compile, adds_softboxes_to_the_base_and_to_each_other) {
  SceneDesc description;
  SoftboxDesc round, window;
  round.direction = {0, 0, -1e-3};  // of any length
  round.shape = RoundShapeDesc{10};
  round.scale = 5;
  window.direction = {0, 0, -7e5};
  window.shape = WindowShapeDesc{40, 10, 90};  // rolled: 10 wide, 40 high
  window.illuminant = "d65";
  window.scale = 2;
  description.environment.softboxes = {round, window};
  const Scene scene = compiled(description);
  EXPECT_EQ(scene.environment.channels.size(), 1u);  // one lamp, one channel
  const auto towards = [](double right_deg, double up_deg) {
    const double degree = std::numbers::pi / 180;
    return Vec3d{std::tan(right_deg * degree), std::tan(up_deg * degree), -1};
  };
  EXPECT_NEAR(luminance(scene, towards(0, 0)), 8, 1e-12);
  EXPECT_NEAR(luminance(scene, towards(0, 9.9)), 8, 1e-12);
  EXPECT_NEAR(luminance(scene, towards(0, 10.1)), 3, 1e-12);
  EXPECT_NEAR(luminance(scene, towards(0, 19.9)), 3, 1e-12);
  EXPECT_NEAR(luminance(scene, towards(0, 20.1)), 1, 1e-12);
  EXPECT_NEAR(luminance(scene, towards(5.1, 0)), 6, 1e-12);
  EXPECT_NEAR(luminance(scene, {0, 0, 1}), 1, 1e-12);
}

// A picture of 4 x 2: from the left the azimuths -135, -45, 45 and 135 degrees.
Resources with_picture() {
  Resources resources;
  resources.picture = [](const std::string&) -> Result<io::RgbImage> {
    io::RgbImage image;
    image.width = 4;
    image.height = 2;
    for (float value : {1.f, 2.f, 3.f, 4.f, 10.f, 20.f, 30.f, 40.f}) image.rgb.insert(image.rgb.end(), 3, value);
    return image;
  };
  return resources;
}

TEST(Compile, maps_a_picture_onto_the_sky) {
  SceneDesc description;
  description.environment.base = ImageEnvironmentDesc{"any.exr", 0, 1};
  const Scene scene = compiled(description, with_picture());
  ASSERT_EQ(scene.environment.channels.size(), 3u);
  const double s = std::sqrt(0.5);  // texel centres stand 45 degrees above and below the horizon
  // (1, 1, 1) at scale 1 has Y = 1, as close as the basis spectra reproduce white.
  EXPECT_NEAR(luminance(scene, {-0.5, s, 0.5}), 1, 1e-3);
  EXPECT_NEAR(luminance(scene, {-0.5, s, -0.5}), 2, 1e-3);
  EXPECT_NEAR(luminance(scene, {0.5, s, -0.5}), 3, 1e-3);
  EXPECT_NEAR(luminance(scene, {0.5, -s, 0.5}), 40, 1e-2);
  EXPECT_NEAR(luminance(scene, {0, s, -s}), 2.5, 1e-3);  // between two texels
  EXPECT_NEAR(luminance(scene, {0, s, s}), 2.5, 1e-3);   // across the seam: (4 + 1)/2
  EXPECT_NEAR(luminance(scene, {0, 1, 0}), 2.5, 1e-3);   // clamped at the top
}

TEST(Compile, turns_a_picture_by_its_rotation) {
  SceneDesc description;
  description.environment.base = ImageEnvironmentDesc{"any.exr", 90, 2};
  const Scene scene = compiled(description, with_picture());
  const double s = std::sqrt(0.5);
  // u = 0.5 + (azimuth - rotation)/360: what stood at azimuth -45 degrees stands at 45.
  EXPECT_NEAR(luminance(scene, {0.5, s, -0.5}), 2 * 2, 1e-2);
}

TEST(Compile, warns_once_for_a_medium_used_outside_its_range) {
  Resources resources;
  resources.medium = [](std::string_view name, bool) -> Result<optics::Medium> {
    return optics::Medium::table({{400, 1.3, 0}, {700, 1.4, 0}}, {std::string(name), "", ""});
  };
  SceneDesc description;
  for (const char* medium : {"narrow", "narrow", "other"})
    description.objects.push_back(
        BubbleDesc{{0, 0, 0}, 1, MediumFilmDesc{"file:" + std::string(medium), film::ConstantThickness{}}});
  Diagnostics warnings;
  ASSERT_TRUE(compile(description, resources, &warnings).ok());
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].severity, Severity::warning);
  EXPECT_EQ(warnings[0].key, "objects[0].bubble.film");
  EXPECT_NE(warnings[0].message.find("400..700 nm"), std::string::npos) << warnings[0].message;
  EXPECT_EQ(warnings[1].key, "objects[2].bubble.film");
}

TEST(Compile, hands_on_what_kind_of_failure_a_file_was) {
  Resources resources;
  resources.picture = [](const std::string&) { return Result<io::RgbImage>(fail(Failure::file, "cannot open")); };
  SceneDesc description;
  description.environment.base = ImageEnvironmentDesc{"any.exr", 0, 1};
  const Result<Scene> scene = compile(description, resources);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.errors()[0].failure, Failure::file);
  EXPECT_EQ(scene.errors()[0].key, "environment.image.file");
}

TEST(LoadScene, gives_the_places_of_problems_that_only_compiling_finds) {
  const std::string text =
      "shabon: 1\nenvironment: {constant: {}}\nobjects:\n"
      "  - bubble: {film: {stack: 'air | 1.5 3nm | file:x.csv'}}\n";
  Resources resources;
  resources.medium = [](std::string_view, bool is_file) -> Result<optics::Medium> {
    return optics::Medium::constant(is_file ? 1.4 : 1.0);
  };
  const Result<Scene> scene = load_scene(text, "scene.yaml", {}, resources);
  ASSERT_FALSE(scene.ok());
  ASSERT_EQ(scene.errors().size(), 1u) << to_text(scene.errors());
  EXPECT_EQ(scene.errors()[0].line, 4);
  EXPECT_EQ(scene.errors()[0].column, 28);
}

}  // namespace
}  // namespace shabon::scene
