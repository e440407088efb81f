// Bubbles that burst and tremble, as they are seen.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "shabon/scene/compile.h"

namespace shabon {
namespace {

using math::Vec3d;

constexpr int side = 40;

// Bubbles have more samples at their rims: pictures differ by that, in light that differs from place to place.
constexpr double most_by_chance = 1e-3;

// What the renderer's two kernels are chosen by: a scene of bubbles alone, or one with another object (out of sight).
const std::string kernels[] = {
    "", "  - quad: {position: [0, 0, 30], surface: {film: {medium: water, thickness: {constant_nm: 0}}}}\n"};
const std::string models[] = {"airy", "two-beam", "none"};

scene::Scene scene_of(const std::string& objects, const std::string& model = "airy", double time_s = 0,
                      const std::string& light = "gradient: {up: {scale: 1}, down: {scale: 0.2}}") {
  auto scene = scene::load_scene("shabon: 1\nmetres_per_unit: 0.03\ntime_s: " + std::to_string(time_s) +
                                     "\nimage: {width: 40, height: 40}\n"
                                     "camera: {position: [0, 0, 6], vertical_fov_deg: 24}\n"
                                     "render: {samples: 4, interference: " +
                                     model + "}\nenvironment: {" + light + "}\nobjects:\n" + objects,
                                 "test.yaml", {}, {});
  if (!scene) throw std::invalid_argument(to_text(scene.errors()));
  return *std::move(scene);
}

render::Sensor picture_of(const scene::Scene& scene) {
  render::Sensor sensor(scene.width, scene.height);
  EXPECT_TRUE(render::render(scene, {}, sensor));
  return sensor;
}

// The largest difference of Y in the rows from..to.
double difference(const scene::Scene& a, const scene::Scene& b, int from = 0, int to = side) {
  const render::Sensor one = picture_of(a), other = picture_of(b);
  double worst = 0;
  for (int y = from; y < to; ++y)
    for (int x = 0; x < side; ++x) worst = std::max(worst, std::abs(one.mean(x, y).y - other.mean(x, y).y));
  return worst;
}

const std::vector<double> wavelengths_nm = {430, 550, 670};

std::vector<double> seen(const scene::Scene& scene, const Vec3d& from, const Vec3d& towards) {
  const auto result = render::probe(scene, {from, towards - from, true}, wavelengths_nm, {64, 1});
  EXPECT_TRUE(result);
  return result ? result->radiance : std::vector<double>(wavelengths_nm.size());
}

// With a hole from the top down to 120 degrees no ray above y = -0.5 meets any film, and none below misses it: only
// what the film reflects to and fro within the bubble may be lost in the hole.
TEST(Popping, leaves_nothing_in_the_hole_and_all_around_it) {
  const std::string film = "film: {medium: water, thickness: {constant_nm: 500}}";
  const std::string none = "  - bubble: {center: [0, 90, 0], " + film + "}\n", whole = "  - bubble: {" + film + "}\n";
  // v = 10 m/s: 120 degrees of 3 cm after 6.28 ms
  const std::string holed = "  - bubble: {popping: {start_s: 1}, " + film + "}\n";
  const double time_s = 1 + 2 * 3.14159265 / 3 * 0.03 / 10;
  for (const std::string& model : models)
    for (const std::string& other : kernels) {
      SCOPED_TRACE(model + other);
      scene::Scene bubble = scene_of(whole + other, model), burst = scene_of(holed + other, model, time_s);
      const scene::Scene empty = scene_of(none + other, model);
      ASSERT_EQ(burst.spheres.size(), 1u);
      // A row of the picture is 0.064 wide; the edge at -0.5 and its rim lie in rows 26 to 29.
      EXPECT_LT(difference(burst, empty, 0, 26), most_by_chance);
      EXPECT_GT(difference(bubble, empty, 0, 26), 5 * most_by_chance);
      // Further down only the rim's image in the film is new, which few rays meet. The two-beam model makes light near
      // the edge, where the walls hand it to and fro.
      if (model != "two-beam") {
        burst.render.samples = bubble.render.samples = 256;
        EXPECT_LT(difference(burst, bubble, 33, side), 10 * most_by_chance);
      }
      EXPECT_GT(difference(burst, empty, 31, side), 5 * most_by_chance);
      const Vec3d eye{0, 0, 6};
      const std::vector<double> in_hole = seen(burst, eye, {0.1, -0.3, 0}),
                                background = seen(empty, eye, {0.1, -0.3, 0}), below = seen(burst, eye, {0.1, -0.8, 0}),
                                film_there = seen(bubble, eye, {0.1, -0.8, 0});
      for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
        EXPECT_NEAR(in_hole[i], background[i], 1e-5 * background[i]);
        EXPECT_NEAR(below[i], film_there[i], 0.02 * film_there[i]);
      }
    }
}

// Also for light that a polariser lets through: the light keeps its polarisation.
TEST(Popping, leaves_polarised_light_alone) {
  for (const std::string& model : models) {
    scene::Scene holed = scene_of("  - bubble: {film: {medium: water, thickness: {constant_nm: 0}}}\n", model);
    scene::Scene empty = holed;
    empty.spheres.clear(), empty.films.clear();
    holed.camera.polarizer_rad = empty.camera.polarizer_rad = 0.4;
    EXPECT_LT(difference(holed, empty), most_by_chance) << model;
    const Vec3d eye{0, 0, 6}, towards{0.5, 0.8, 0};
    const auto with = seen(holed, eye, towards), without = seen(empty, eye, towards);
    for (std::size_t i = 0; i < with.size(); ++i) EXPECT_NEAR(with[i], without[i], 1e-5 * without[i]) << model;
  }
}

const std::string lobes =
    ", modes: [{amplitude_m: 0.006, axis: [0, 1, 0.3]}, {degree: 3, amplitude_m: 0.003, axis: [1, 0, 0]}, {degree: 5, "
    "amplitude_m: 0.001, axis: [0, 0.2, 1]}]";

std::string bubble_of(const std::string& film, const std::string& more = "") {
  return "  - bubble: {film: {" + film + "}" + more + "}\n";
}

// Of the index around it, and of no thickness: nothing is there, nor does light go astray in the lobes.
TEST(Trembling, of_no_film_is_not_seen) {
  const scene::Scene empty = scene_of("  []\n");
  for (const std::string film :
       {"medium: air, thickness: {constant_nm: 500}", "medium: water, thickness: {constant_nm: 0}"}) {
    const scene::Scene scene = scene_of(bubble_of(film, lobes + ", body: {thickness_nm: 500}"));
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_LT(difference(scene, empty), 1e-5) << film;
  }
}

// In a furnace what the walls reflect into a ray is what they reflect out of it, however the surface is bent.
TEST(Trembling, is_not_seen_in_the_same_light_from_everywhere) {
  for (const std::string& model : {models[0], models[2]}) {
    scene::Scene scene = scene_of(bubble_of("medium: water, thickness: {linear: {top_nm: 200, bottom_nm: 900}}", lobes),
                                  model, 0, "constant: {}");
    scene.render.samples = 64;
    const render::Sensor sensor = picture_of(scene);
    double worst = 0, mean = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        worst = std::max(worst, std::abs(sensor.mean(x, y).y - 1)), mean += sensor.mean(x, y).y / (side * side);
    EXPECT_LT(worst, 0.02) << model;
    EXPECT_NEAR(mean, 1, 1e-4) << model;
  }
}

// Without amplitude it is the round bubble, which another kernel renders; with some it is not.
TEST(Trembling, without_amplitude_is_round) {
  for (const std::string film : {"medium: water, thickness: {linear: {top_nm: 200, bottom_nm: 900}}",
                                 "medium: water, thickness: {noise: {base: {constant_nm: 500}, swirl: 0.3}}"}) {
    scene::Scene round = scene_of(bubble_of(film)), still = scene_of(bubble_of(film, ", modes: [{amplitude_m: 0}]")),
                 slight = scene_of(bubble_of(film, ", modes: [{amplitude_m: 0.00003}]")),
                 lobed = scene_of(bubble_of(film, lobes));
    for (scene::Scene* scene : {&round, &still, &slight, &lobed}) scene->render.samples = 64;
    EXPECT_LT(difference(round, still), 5e-3) << film;
    EXPECT_LT(difference(round, slight), 0.05) << film;
    EXPECT_GT(difference(round, lobed), 0.03) << film;
    const Vec3d eye{0, 0, 6}, towards{0.3, 0.5, 0};
    const auto a = seen(round, eye, towards), b = seen(still, eye, towards), c = seen(slight, eye, towards);
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(b[i], a[i], 1e-3 * a[i]) << film;
      EXPECT_NEAR(c[i], a[i], 0.02 * a[i]) << film;
    }
  }
}

}  // namespace
}  // namespace shabon
