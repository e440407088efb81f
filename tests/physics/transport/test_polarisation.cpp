// What a polariser before the camera sees of a film: extinction at Brewster's angle, single paths by their formula,
// and sums that do not depend on its angle.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scenes.h"
#include "shabon/render/probe.h"

namespace shabon {
namespace {

constexpr double n = 1.5, film_nm = 300, wavelength_nm = 550, lamp_scale = 1000;

struct Powers {
  double R_s, R_p;
};

// The free film without loss, R = F/(1 + F), equation (10).
Powers film_powers(double incidence_rad) {
  const double c1 = std::cos(incidence_rad), s2 = std::sin(incidence_rad) / n, c2 = std::sqrt(1 - s2 * s2);
  const double u = std::pow(std::sin(2 * std::numbers::pi * n * film_nm * c2 / wavelength_nm), 2);
  const auto reflectance = [&](double r) {
    const double rho = r * r, F = 4 * rho * u / ((1 - rho) * (1 - rho));
    return F / (1 + F);
  };
  return {reflectance((c1 - n * c2) / (c1 + n * c2)), reflectance((n * c1 - c2) / (n * c1 + c2))};
}

// A camera above the axis of a bubble looks along -z at its wall under `incidence`; the only lamp is a narrow one that
// light meets after `inner` reflections inside the bubble (-1: after the one outside).
scene::SceneDesc one_path(double incidence_rad, int inner) {
  scene::SceneDesc scene;
  const double height = std::sin(incidence_rad);
  scene.image = {1, 1};
  scene.camera.position = {0, height, 5};
  scene.camera.look_at = {0, height, 0};
  scene.camera.vertical_fov_deg = 1;
  scene.objects = {testing_scenes::bubble({0, 0, 0}, 1, "1.5", film::ConstantThickness{film_nm})};
  scene.environment = testing_scenes::uniform("E", 0);
  // Every reflection turns the ray by pi - 2 theta: upwards outside, downwards inside.
  const double turn = std::numbers::pi - 2 * incidence_rad, angle = inner < 0 ? turn : -inner * turn;
  scene.environment.softboxes = {
      {{"E", lamp_scale}, {0, std::sin(angle), -std::cos(angle)}, scene::RoundShapeDesc{1e-4}}};
  return scene;
}

// As a share of the lamp.
double seen(scene::SceneDesc scene, std::optional<double> polarizer_deg) {
  scene.camera.polarizer_deg = polarizer_deg;
  const scene::Scene compiled = testing_scenes::compiled(scene);
  scene::SceneDesc bare = scene;
  bare.objects.clear();
  bare.camera.polarizer_deg.reset();
  bare.environment = testing_scenes::uniform("E", lamp_scale);
  const double nm[] = {wavelength_nm};
  const auto light = render::probe(compiled, render::pixel_ray(compiled, 0.5, 0.5), nm);
  const auto lamp = render::probe(testing_scenes::compiled(bare), render::pixel_ray(compiled, 0.5, 0.5), nm);
  if (!light || !lamp) throw std::invalid_argument("not probed");
  return light->radiance[0] / lamp->radiance[0];
}

const double brewster_rad = std::atan(n);

TEST(Polariser, extinguishes_what_a_film_reflects_at_brewsters_angle) {
  const scene::SceneDesc scene = one_path(brewster_rad, -1);
  const double R_s = film_powers(brewster_rad).R_s;
  EXPECT_GT(R_s, 0.1);
  EXPECT_NEAR(seen(scene, 0), R_s / 2, 1e-12);  // image right is s
  EXPECT_LT(seen(scene, 90), 1e-12);
  EXPECT_NEAR(seen(scene, 45), R_s / 4, 1e-12);
  EXPECT_NEAR(seen(scene, 30), R_s / 2 * 0.75, 1e-12);  // Malus
  EXPECT_NEAR(seen(scene, {}), R_s / 2, 1e-12);
}

TEST(Polariser, sees_single_paths_by_their_formula) {
  for (const double incidence_deg : {20.3, 47.1, 61.7, 75.43, 86.17}) {
    const double incidence_rad = incidence_deg * std::numbers::pi / 180;
    const Powers R = film_powers(incidence_rad);
    for (const int inner : {-1, 1, 2}) {
      // Outside R; inside T, the reflections, T.
      const auto path = [&](double r) { return inner < 0 ? r : (1 - r) * (1 - r) * std::pow(r, inner); };
      const scene::SceneDesc scene = one_path(incidence_rad, inner);
      EXPECT_NEAR(seen(scene, 0), path(R.R_s) / 2, 1e-9) << incidence_deg << ", " << inner;
      EXPECT_NEAR(seen(scene, 90), path(R.R_p) / 2, 1e-9) << incidence_deg << ", " << inner;
      EXPECT_NEAR(seen(scene, {}), (path(R.R_s) + path(R.R_p)) / 2, 1e-9) << incidence_deg << ", " << inner;
    }
  }
}

// The means of s and p at every wall are the paper's; there a polariser only halves.
TEST(Polariser, halves_the_two_beam_model) {
  scene::SceneDesc scene = one_path(brewster_rad, -1);
  scene.render.interference = optics::Interference::two_beam;
  const double whole = seen(scene, {});
  for (const double angle : {0.0, 33.0, 90.0}) EXPECT_NEAR(seen(scene, angle), whole / 2, 1e-12) << angle;
}

// Two crossed polarisers between them pass everything.
TEST(Polariser, and_its_crossed_one_see_all_light) {
  const double nm[] = {550};
  for (const std::string name : {"single", "overlapping", "touching", "air in water", "cluster", "absorbing"}) {
    for (const auto model : {optics::Interference::airy, optics::Interference::none}) {
      scene::SceneDesc description =
          testing_scenes::scene_of(testing_scenes::arrangement(name), testing_scenes::light("softboxes"));
      description.render.interference = model;
      const auto through = [&](std::optional<double> angle, int pixel) {
        description.camera.polarizer_deg = angle;
        const scene::Scene scene = testing_scenes::compiled(description);
        return render::probe(scene, render::pixel_ray(scene, pixel % 4 + 2.2, pixel / 4 + 2.7), nm).value().radiance;
      };
      for (int pixel = 0; pixel < 16; pixel += 5) {
        const auto all = through({}, pixel), across = through(0, pixel), up = through(90, pixel);
        const auto slanted = through(-28, pixel), against = through(62, pixel);
        for (std::size_t i = 0; i < all.size(); ++i) {
          // The trees may be cut at different branches.
          EXPECT_NEAR(across[i] + up[i], all[i], 3e-5 * all[i]) << name << ", " << pixel;
          EXPECT_NEAR(slanted[i] + against[i], all[i], 3e-5 * all[i]) << name << ", " << pixel;
        }
      }
    }
  }
}

}  // namespace
}  // namespace shabon
