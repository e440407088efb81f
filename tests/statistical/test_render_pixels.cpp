// Whole pixels: the mean of many samples is the integral of what arrives over the pixel's area, by the probe on a grid.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shabon/color/observer.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "tests/physics/transport/scenes.h"

namespace shabon {
namespace {

using Colour = std::array<double, 3>;

constexpr int samples = 256;  // a multiple of the 64 combs

// Pixels as large as life: the rim, the background and all that is mirrored near the rim in one pixel. The lamp has no
// lines, so that every fifth wavelength will do; samples fill the pixel evenly.
TEST(RenderPixels, are_the_integral_over_their_area) {
  scene::SceneDesc description = scene_of(testing_scenes::arrangement("even"), testing_scenes::uniform("E"));
  description.environment.base = scene::GradientEnvironmentDesc{{"E", 1}, {"E", 0.1}};
  description.image = {3, 3};
  description.render.samples = samples;
  scene::Scene scene = testing_scenes::compiled(description);
  std::vector<double> nm;
  for (int i = 362; i <= 828; i += 5) nm.push_back(i);
  const auto integral = [&](int x, int y, int fine) {
    Colour sum{};
    for (int i = 0; i < fine * fine; ++i) {
      const double u = (i % fine + 0.5) / fine, v = (i / fine + 0.5) / fine;
      const auto radiance = render::probe(scene, render::pixel_ray(scene, x + u, y + v), nm).value().radiance;
      for (std::size_t w = 0; w < nm.size(); ++w) {
        const auto at = static_cast<std::size_t>(nm[w] - color::first_nm);
        const color::Observer& observer = color::observer_1931();
        sum[0] += 5 * radiance[w] * observer.x[at] / (fine * fine);
        sum[1] += 5 * radiance[w] * observer.y[at] / (fine * fine);
        sum[2] += 5 * radiance[w] * observer.z[at] / (fine * fine);
      }
    }
    return sum;
  };
  constexpr int few_renders = 8;
  std::vector<render::Sensor> sensors(few_renders, render::Sensor(3, 3));
  for (int i = 0; i < few_renders; ++i) {
    scene.render.seed = static_cast<std::uint64_t>(i);
    ASSERT_TRUE(render::render(scene, {}, sensors[static_cast<std::size_t>(i)]).ok());
  }
  for (const auto& [x, y] : {std::pair{0, 1}, {1, 1}, {2, 0}}) {
    const Colour coarse = integral(x, y, 14), fine = integral(x, y, 22);
    Colour mean{};
    for (const render::Sensor& sensor : sensors) {
      const color::Xyz xyz = sensor.mean(x, y);
      mean[0] += xyz.x / few_renders, mean[1] += xyz.y / few_renders, mean[2] += xyz.z / few_renders;
    }
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(mean[k], fine[k], 2 * std::abs(coarse[k] - fine[k]) + 5e-4) << x << ' ' << y << ' ' << "XYZ"[k];
  }
}

}  // namespace
}  // namespace shabon
