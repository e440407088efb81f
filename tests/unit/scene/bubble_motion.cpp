// Bubbles whose shape changes in time: what the scene's film and shape are then.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/scene/compile.h"

namespace shabon::scene {
namespace {

using math::Vec3d;

Result<Scene> load(const std::string& bubble, double time_s) {
  Resources resources;
  resources.texture = [](const std::string&) -> Result<TextureFile> {
    return TextureFile{{4, 2, 1, std::vector<float>(8, 600.0f)}};
  };
  return load_scene("shabon: 1\nmetres_per_unit: 0.05\ntime_s: " + std::to_string(time_s) +
                        "\nenvironment: {constant: {}}\nobjects:\n  - bubble: {" + bubble + "}\n",
                    "test.yaml", {}, resources);
}

Scene loaded(const std::string& bubble, double time_s) {
  Result<Scene> scene = load(bubble, time_s);
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
  return scene ? *std::move(scene) : Scene{};
}

double nm_at(const Scene& scene, double angle_from_top) {
  return film::thickness_nm(scene.films.at(0).thickness, Vec3d{0.6 * std::sin(angle_from_top), std::cos(angle_from_top),
                                                               -0.8 * std::sin(angle_from_top)});
}

// 5 cm, 1 um, 25 mN/m: the rim runs at sqrt(50) m/s and is round the bubble in 22.2 ms.
const double speed_m_s = std::sqrt(50.0);
const std::string plain = "film: {medium: water, thickness: {constant_nm: 1000}}";

TEST(Popping, opens_a_hole_at_the_speed_of_the_rim) {
  const std::string bubble = plain + ", popping: {start_s: 0.5, slow_motion: 10}";
  for (const double later_s : {0.001, 0.05, 0.1, 0.15}) {
    const Scene scene = loaded(bubble, 0.5 + later_s);
    ASSERT_EQ(scene.spheres.size(), 1u);
    const double rim = speed_m_s * later_s / 0.05 / 10;
    EXPECT_EQ(nm_at(scene, rim - 1e-4), 0) << later_s;
    EXPECT_EQ(nm_at(scene, rim + 1e-4), 1000) << later_s;
    EXPECT_EQ(nm_at(scene, std::numbers::pi), 1000) << later_s;
  }
}

TEST(Popping, waits_and_ends) {
  const std::string bubble = plain + ", popping: {start_s: 0.5}";
  EXPECT_EQ(nm_at(loaded(bubble, 0), 0), 1000);
  EXPECT_EQ(nm_at(loaded(bubble, 0.5), 0), 1000);
  EXPECT_EQ(nm_at(loaded(bubble, 0.5001), 0), 0);
  EXPECT_EQ(loaded(bubble, 0.515).spheres.size(), 1u);
  for (const double time_s : {0.5 + std::numbers::pi * 0.05 / speed_m_s, 0.6, 1e6}) {
    const Scene scene = loaded(bubble, time_s);
    EXPECT_TRUE(scene.spheres.empty() && scene.films.empty() && scene.objects.empty()) << time_s;
  }
}

// The angle in rad of the hole's rim, from its film.
double rim_of(const Scene& scene) { return std::acos(std::get<film::HoledFilm>(scene.films.at(0).thickness).cos_hole); }

TEST(Popping, knows_the_bubble_in_nature) {
  constexpr double time_s = 0.002;
  const auto rim = [&](const std::string& keys) { return rim_of(loaded(keys + ", popping: {}", time_s)); };
  const double plainly = rim(plain);
  EXPECT_NEAR(plainly, speed_m_s * time_s / 0.05, 1e-9);
  EXPECT_NEAR(rim(plain + ", radius: 2"), plainly / 2, 1e-9);
  EXPECT_NEAR(rim(plain + ", body: {radius_m: 0.025}"), plainly * 2, 1e-9);
  EXPECT_NEAR(rim(plain + ", body: {thickness_nm: 4000}"), plainly / 2, 1e-9);
  EXPECT_NEAR(rim(plain + ", body: {tension_n_m: 0.1}"), plainly * 2, 1e-9);
  EXPECT_NEAR(rim(plain + ", body: {density_kg_m3: 4000}"), plainly / 2, 1e-9);
  EXPECT_NEAR(rim("film: {stack: 'air | water 1000nm | air'}"), plainly, 1e-9);
  EXPECT_NEAR(rim("film: {stack: 'air | water 10nm | air', vary: {thickness: {linear: {top_nm: 500, bottom_nm: "
                  "1500}}}}"),
              plainly, 1e-6);
  EXPECT_NEAR(rim("film: {medium: water, thickness: {map: {file: x.exr}}}, body: {thickness_nm: 1000}"), plainly, 1e-9);
}

// Of a film that ages: as thick as it was when it broke, whatever the moment that is shown.
TEST(Popping, takes_the_film_as_it_was_when_it_broke) {
  const std::string film = "film: {medium: water, thickness: {self_similar: {top_nm: 300, bottom_nm: 900, age_s: 4}}}";
  const auto rim = [&](double later_s) {
    return rim_of(loaded(film + ", popping: {start_s: 100, slow_motion: 1000}", 100 + later_s));
  };
  EXPECT_NEAR(rim(4) / rim(1), 4, 1e-6);
}

TEST(Popping, leaves_pictures_where_they_are) {
  const Scene scene =
      loaded("film: {medium: water, thickness: {map: {file: x.exr}}}, body: {thickness_nm: 1000}, popping: {}", 0.01);
  EXPECT_EQ(nm_at(scene, 1.4), 0);
  EXPECT_NEAR(nm_at(scene, 1.43), 600, 1e-3);
}

}  // namespace
}  // namespace shabon::scene
