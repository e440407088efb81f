// Bubbles whose shape changes in time: what the scene's film and shape are then.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/scene/compile.h"
#include "shabon/scene/running_films.h"

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

// All the liquid of the hole is a ring that touches the film from within the hole.
TEST(Popping, gathers_the_liquid_in_a_rim) {
  using std::numbers::pi;
  const std::string bubble =
      plain + ", center: [1, 2, 3], radius: 2, body: {radius_m: 0.05}, popping: {from_centre: [0, 0, 3]}";
  for (const double time_s : {1e-5, 1e-3, 0.01, 0.02}) {
    const Scene scene = loaded(bubble, time_s);
    ASSERT_EQ(scene.objects.size(), 1u);
    const auto& [shape, surface, place] = scene.objects[0];
    EXPECT_EQ(place, 0);
    const double ring = shape.uniform_scale, tube = ring * std::get<geometry::Torus>(shape.shape).tube;
    const double edge = speed_m_s * time_s / 0.05, swept = 2 * pi * 4 * (1e-6 / 0.025) * (1 - std::cos(edge));
    EXPECT_NEAR(2 * pi * pi * ring * tube * tube / swept, 1, 0.02 + tube / ring) << time_s;
    EXPECT_NEAR(math::length(shape.to_world.origin - Vec3d{1, 2, 3}), std::sqrt(4 - ring * ring), 1e-12);
    const Vec3d film_edge = Vec3d{1, 2, 3} + Vec3d{0, std::sin(edge), std::cos(edge)} * 2;
    const Vec3d line = shape.to_world.origin + Vec3d{0, ring, 0};
    EXPECT_NEAR(math::length(film_edge - line), tube, 1e-12);
    const auto& liquid = std::get<DielectricSurface>(scene.surfaces.at(static_cast<std::size_t>(surface)));
    EXPECT_EQ(liquid.coating.stack.exit.name(), "water");
  }
  EXPECT_TRUE(loaded(bubble, 0).objects.empty());
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

// 5 cm, 1 um: the mode of degree 2 trembles at 6.3 Hz.
double radius_of(const Scene& scene, Vec3d n) {
  const geometry::PlacedShape& placed = scene.objects.at(0).shape;
  const auto far = geometry::next_crossing(placed, placed.to_world.origin, n, false);
  return far.value_or(0);
}

const std::string lobes = ", modes: [{degree: 2, amplitude_m: 0.002, axis: [0, 2, 0], quality: 5}]";

TEST(Trembling, is_the_shape_of_its_modes) {
  const std::string bubble = plain + ", center: [1, 2, 3], radius: 1.5, body: {radius_m: 0.05}" +
                             ", modes: [{degree: 2, amplitude_m: 0.004, axis: [0, 0.5, 0]}, {degree: 3, amplitude_m: "
                             "0.003, axis: [1, 1, 0], phase_deg: 40}]";
  film::BubbleBody body;
  body.radius_m = 0.05, body.thickness_m = 1e-6;
  const std::vector<film::ShapeMode> modes = {{2, 0.004, {0, 1, 0}, 0, 10},
                                              {3, 0.003, math::normalize(Vec3d{1, 1, 0}), 40, 10}};
  for (const double time_s : {0.0, 0.02, 0.3}) {
    const Scene scene = loaded(bubble, time_s);
    ASSERT_EQ(scene.spheres.size(), 0u);
    ASSERT_TRUE(std::holds_alternative<FreeFilmSurface>(scene.surfaces.at(0)));
    for (const Vec3d n : {Vec3d{0, 1, 0}, {1, 0, 0}, {0.6, 0, -0.8}, {-0.48, 0.6, 0.64}})
      EXPECT_NEAR(radius_of(scene, n), 1.5 * film::radius_m(body, modes, n, time_s) / 0.05, 1e-12) << time_s;
  }
}

// After half a period of the damped mode the lobes are where the waist was, smaller by its damping.
TEST(Trembling, swings_to_the_other_side_in_half_a_period) {
  film::BubbleBody body;
  body.radius_m = 0.05, body.thickness_m = 1e-6;
  const double frequency = film::shape_frequency_rad_s(body, 2), damping = frequency / 10;
  const double half_s = std::numbers::pi / std::sqrt(frequency * frequency - damping * damping);
  const auto lobe = [&](double time_s) {
    return std::get<geometry::LobedSphere>(loaded(plain + lobes, time_s).objects.at(0).shape.shape).lobes.at(0);
  };
  const double start = lobe(0).amplitude;
  EXPECT_NEAR(start, 0.04, 1e-15);
  EXPECT_EQ(lobe(0).axis, (Vec3d{0, 1, 0}));
  EXPECT_NEAR(lobe(half_s).amplitude / start, -std::exp(-damping * half_s), 1e-5);
  EXPECT_NEAR(lobe(2 * half_s).amplitude / start, std::exp(-2 * damping * half_s), 1e-5);
  EXPECT_NEAR(lobe(half_s / 2).amplitude, 0, 1e-6);
}

TEST(Trembling, bubbles_burst_too) {
  const std::string bubble = plain + lobes + ", popping: {start_s: 0.5}";
  EXPECT_EQ(nm_at(loaded(bubble, 0.501), 0), 0);
  EXPECT_EQ(nm_at(loaded(bubble, 0.501), 3), 1000);
  EXPECT_TRUE(loaded(bubble, 0.6).objects.empty());
}

TEST(Trembling, lays_pictures_by_direction) {
  const Scene scene =
      loaded("film: {medium: water, thickness: {map: {file: x.exr}}}, body: {thickness_nm: 1000}" + lobes, 0);
  EXPECT_FALSE(scene.films.at(0).thickness_map_nm);
  EXPECT_NEAR(nm_at(scene, 1), 600, 1e-3);
}

// A film so thin that it breaks in its first step.
const std::string breaking =
    "film: {medium: water, thickness: {flow: {level: 2, radius_m: 0.03, mean_thickness_nm: 300, rupture: {from_nm: "
    "990, "
    "to_nm: 1000}}}}";

struct Run {
  Scene scene;
  film::FilmFlow::Rupture rupture;
};

Run run(const std::string& bubble, double later_s) {
  Scene scene = loaded(bubble, 0.5);
  auto films = RunningFilms::start(scene);
  EXPECT_TRUE(films.ok());
  EXPECT_TRUE(films->advance_to(0.5).ok());
  auto flow = film::FilmFlow::start(*scene.films.at(0).flow);
  EXPECT_TRUE(flow->advance_to(0.5).ok());
  Run result{std::move(scene), {}};
  if (films->rupture()) result.rupture = *flow->rupture(), result.rupture.time_s = films->rupture()->time_s;
  result.scene.time_s = result.rupture.time_s + later_s;
  films->show_in(result.scene);
  return result;
}

TEST(Popping, opens_a_simulated_film_where_it_broke) {
  for (const double slow : {1.0, 50.0}) {
    constexpr double later_s = 0.002;
    const auto [scene, rupture] =
        run(breaking + (slow > 1 ? ", popping: {start_s: 77, from_centre: [0, -1, 0], slow_motion: 50}" : ""), later_s);
    ASSERT_LT(rupture.time_s, 0.1);
    const auto& holed = std::get<film::HoledFilm>(scene.films[0].thickness);
    const double mean_m = 1e-9 * film::mean_thickness_nm(holed.film->field);
    EXPECT_NEAR(mean_m, 300e-9, 40e-9);
    const double rim_speed_m_s = std::sqrt(2 * 0.025 / (1000 * mean_m));
    EXPECT_NEAR(std::acos(holed.cos_hole), rim_speed_m_s * later_s / 0.03 / slow, 1e-9) << slow;
    EXPECT_NEAR(math::length(holed.axis - math::normalize(rupture.from_centre)), 0, 1e-12);
    EXPECT_FALSE(has_idle_film(scene));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<geometry::Torus>(scene.objects[0].shape.shape));
  }
}

// Looks at moments between its pauses, or none: the film is the same afterwards, to the last bit.
TEST(RunningFilms, do_not_depend_on_who_looks_on) {
  const std::string bubble =
      "film: {medium: water, thickness: {flow: {level: 2, initial: {noise: 0.3, swirl_m_s: 0.4}, evaporation: {}}}}";
  const auto map_at = [&](const std::vector<double>& times_s) {
    Scene scene = loaded(bubble, times_s.back());
    auto films = RunningFilms::start(scene);
    EXPECT_TRUE(films.ok());
    for (const double time_s : times_s) EXPECT_TRUE(films->advance_to(time_s).ok());
    films->show_in(scene);
    return std::get<std::shared_ptr<const film::SphereMap>>(scene.films.at(0).thickness)->nm;
  };
  const auto alone = map_at({0.55});
  EXPECT_EQ(map_at({0.1, 0.2, 0.3, 0.4, 0.5, 0.55}), alone);
  EXPECT_EQ(map_at({0.04, 0.13, 0.52, 0.53, 0.55}), alone);
  EXPECT_NE(map_at({0.54}), alone);
}

TEST(Popping, leaves_nothing_of_a_simulated_film) {
  const Scene gone = run(breaking, 0.1).scene,
              told = run("film: {medium: water, thickness: {flow: {level: 1}}}, "
                         "popping: {start_s: 0.1}",
                         0.5)
                         .scene,
              waiting = run("film: {medium: water, thickness: {flow: {level: 1}}}, popping: {start_s: 10}", 0.5).scene;
  for (const double angle : {0.0, 1.0, 2.0, std::numbers::pi}) {
    EXPECT_EQ(nm_at(gone, angle), 0);
    EXPECT_EQ(nm_at(told, angle), 0);
    EXPECT_GT(nm_at(waiting, angle), 0);
  }
}

// Simulated films keep their places among those that come and go.
TEST(Popping, keeps_simulated_films_apart_from_others) {
  const std::string other =
      "bubble: {film: {medium: water, thickness: {constant_nm: 500}}, popping: {start_s: 1}}\n  - ";
  const std::string flow =
      "film: {medium: water, thickness: {flow: {level: 1, mean_thickness_nm: 900}}}, center: [3, 0, 0]";
  const auto at = [&](double time_s) {
    return *load_scene("shabon: 1\ntime_s: " + std::to_string(time_s) +
                           "\nenvironment: {constant: {}}\nobjects:\n  - " + other + "bubble: {" + flow + "}\n",
                       "test.yaml", {}, {});
  };
  const Scene before = at(0.5);
  Scene after = at(5);
  ASSERT_EQ(before.films.size(), 2u);
  ASSERT_EQ(after.films.size(), 1u);
  const auto films = RunningFilms::start(before);
  ASSERT_TRUE(films);
  films->show_in(after);
  EXPECT_FALSE(has_idle_film(after));
  EXPECT_NEAR(nm_at(after, 1), 900, 300);
}

}  // namespace
}  // namespace shabon::scene
