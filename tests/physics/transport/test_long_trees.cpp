// The probe where its tree is long: along the inside of one bubble near grazing incidence, where the answer is a sum
// that a loop can write down, and among many bubbles, where the tree must be cut to end.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "scenes.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/render/comb.h"
#include "shabon/render/probe.h"

namespace shabon {
namespace {

using math::Vec3d;

constexpr double film_nm = 300, film_index = 1.33;

scene::SceneDesc one_bubble() {
  scene::SceneDesc description =
      testing_scenes::scene_of(testing_scenes::arrangement("single"), testing_scenes::light("windows"));
  description.objects = {
      testing_scenes::bubble({0, 0, 0}, 1, std::to_string(film_index), film::ConstantThickness{film_nm})};
  return description;
}

double radiance(const scene::Scene& scene, const Vec3d& direction, double nm) {
  std::vector<double> amounts(scene.environment.channels.size());
  scene.environment.coefficients(direction, std::span<double>(amounts));
  double sum = 0;
  for (std::size_t k = 0; k < amounts.size(); ++k)
    sum += amounts[k] * render::at_wavelength(scene.environment.channels[k], nm);
  return sum;
}

// The ray from (impact, 0, z) along -z meets the unit sphere, and all its light stays in one plane: s and p never mix.
// Inside, each wall turns the ray by pi - 2 alpha, where sin(alpha) is the impact parameter.
double closed_sum(const scene::Scene& scene, double impact, double nm) {
  const double alpha = std::asin(impact);
  const optics::Powers film = optics::airy(1, film_index, 1, film_nm, optics::incidence_from_cos(std::cos(alpha)), nm);
  const auto along = [](double angle) { return Vec3d{std::sin(angle), 0, -std::cos(angle)}; };
  double sum = 0;
  for (const auto& [R, T] : {std::pair{film.R_s, film.T_s}, std::pair{film.R_p, film.T_p}}) {
    sum += R / 2 * radiance(scene, along(std::numbers::pi - 2 * alpha), nm);
    double inside = T / 2;
    for (int walls = 0; inside > 1e-12; ++walls, inside *= R)
      sum += inside * T * radiance(scene, along(-walls * (std::numbers::pi - 2 * alpha)), nm);
  }
  return sum;
}

TEST(LongTrees, inside_one_bubble_near_grazing_incidence) {
  const scene::Scene scene = testing_scenes::compiled(one_bubble());
  const std::vector<double> wavelengths_nm = {360, 437, 550, 760};
  for (const double impact : {0.5, 0.99, 0.9995, 0.9999, 0.99999, 0.999999}) {
    const auto probed = render::probe(scene, {{impact, 0, 5}, {0, 0, -1}, false}, wavelengths_nm);
    std::vector<double> expected;
    for (const double nm : wavelengths_nm) expected.push_back(closed_sum(scene, impact, nm));
    const double largest = *std::max_element(expected.begin(), expected.end());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(probed->radiance[i] / largest, expected[i] / largest, 2e-6)  // the cut, (27), costs up to 1e-7 each
          << impact << " at " << wavelengths_nm[i] << " nm";
  }
}

TEST(LongTrees, many_bubbles_end_in_time_and_say_what_the_cut_costs) {
  scene::SceneDesc description = one_bubble();
  description.objects.clear();
  for (int i = 0; i < 20; ++i)
    description.objects.push_back(testing_scenes::bubble({0, 0, 0}, 1, "4", film::ConstantThickness{film_nm}));
  const scene::Scene scene = testing_scenes::compiled(description);
  std::vector<double> wavelengths_nm;
  for (int nm = 360; nm <= 830; ++nm) wavelengths_nm.push_back(nm);
  const auto start = std::chrono::steady_clock::now();
  const auto probed = render::probe(scene, {{0.3, 0, 5}, {0, 0, -1}, false}, wavelengths_nm);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 300);  // 1 s alone on two cores; the bound is for slow machines and sanitizers (110 s)
  EXPECT_GT(probed->least_carried, 1e-7);
  EXPECT_GT(probed->cut_carried, 1e-3);

  const scene::Scene one = testing_scenes::compiled(one_bubble());
  const auto small = render::probe(one, {{0.3, 0, 5}, {0, 0, -1}, false}, wavelengths_nm);
  EXPECT_EQ(small->least_carried, 1e-7);
  EXPECT_LT(small->cut_carried, 1e-7);
}

// Groups of wavelengths share a tree; what else is asked for must not matter beyond the cut.
TEST(LongTrees, a_wavelength_does_not_depend_on_its_company) {
  scene::SceneDesc description =
      testing_scenes::scene_of(testing_scenes::arrangement("nested"), testing_scenes::light("windows"));
  const scene::Scene scene = testing_scenes::compiled(description);
  std::vector<double> many;
  for (int nm = 360; nm <= 830; ++nm) many.push_back(nm);
  const render::ProbeRay ray{{0.2, 0.1, 5}, {0, 0, -1}, false};
  const auto together = render::probe(scene, ray, many);
  const double largest = *std::max_element(together->radiance.begin(), together->radiance.end());
  for (std::size_t i = 0; i < many.size(); i += 47) {
    const auto alone = render::probe(scene, ray, std::vector<double>{many[i]});
    EXPECT_NEAR(alone->radiance[0] / largest, together->radiance[i] / largest, 5e-6) << many[i];
  }
  EXPECT_TRUE(render::probe(scene, ray, {})->radiance.empty());
}

}  // namespace
}  // namespace shabon
