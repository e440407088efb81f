// A bubble of lossless film in light that is the same from everywhere cannot be seen: what its films reflect into the
// ray is what they reflect out of it. The two-beam model does not conserve energy, and there it shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "rays.h"
#include "scenes.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/render/comb.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"

namespace shabon {
namespace {

const render::RenderOptions one_thread = [] {
  render::RenderOptions options;
  options.threads = 1;
  return options;
}();

using testing_scenes::Arrangement;

constexpr double tolerance = 1e-5;

std::vector<double> wavelengths(int step_nm) {
  std::vector<double> result;
  for (int nm = color::first_nm; nm <= color::last_nm; nm += step_nm) result.push_back(nm);
  return result;
}

std::vector<double> probed(const scene::Scene& scene, const render::ProbeRay& ray, const std::vector<double>& nm) {
  const auto result = render::probe(scene, ray, nm);
  if (!result) throw std::invalid_argument(result.errors().front().message);
  return result->radiance;
}

// The largest departure from `expected` times the lamp, as a share of it.
double departure(const std::vector<double>& radiance, const std::vector<double>& nm, const color::Spectrum& lamp,
                 double expected) {
  double worst = 0;
  for (std::size_t i = 0; i < nm.size(); ++i)
    worst = std::max(worst, std::abs(radiance[i] / (expected * render::at_wavelength(lamp, nm[i])) - 1));
  return worst;
}

scene::SceneDesc in_uniform_light(const Arrangement& arrangement, const char* lamp) {
  return scene_of(arrangement, testing_scenes::uniform(lamp));
}

// Every pixel centre of the picture.
double worst_pixel(const scene::SceneDesc& description, const char* lamp, int step_nm, double expected) {
  const scene::Scene scene = testing_scenes::compiled(description);
  const color::Spectrum spectrum = color::lamp_radiance(*color::find_illuminant(lamp));
  const std::vector<double> nm = wavelengths(step_nm);
  double worst = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x)
      worst = std::max(
          worst, departure(probed(scene, render::pixel_ray(scene, x + 0.5, y + 0.5), nm), nm, spectrum, expected));
  return worst;
}

TEST(Invisible, to_the_probe_at_every_pixel_and_wavelength) {
  for (const char* lamp : {"D65", "A"}) {
    const double worst = worst_pixel(in_uniform_light(testing_scenes::arrangement("single"), lamp), lamp, 1, 1);
    std::cout << "single under " << lamp << ": " << worst << '\n';
    EXPECT_LE(worst, tolerance) << lamp;
  }
}

TEST(Invisible, to_the_probe_in_every_lossless_arrangement) {
  for (const Arrangement& arrangement : testing_scenes::arrangements()) {
    if (!arrangement.lossless) continue;
    const double worst = worst_pixel(in_uniform_light(arrangement, "D65"), "D65", 47, 1);
    std::cout << arrangement.name << ": " << worst << '\n';
    EXPECT_LE(worst, tolerance) << arrangement.name;
  }
}

TEST(Invisible, behind_a_polariser_at_half_the_light) {
  for (const char* name : {"single", "overlapping", "coincident", "air in water"}) {
    scene::SceneDesc description = in_uniform_light(testing_scenes::arrangement(name), "A");
    description.camera.polarizer_deg = 33;
    EXPECT_LE(worst_pixel(description, "A", 47, 0.5), tolerance) << name;
  }
}

TEST(Invisible, without_phase) {
  for (const char* name : {"single", "overlapping", "coincident"}) {
    scene::SceneDesc description = in_uniform_light(testing_scenes::arrangement(name), "D65");
    description.render.interference = optics::Interference::none;
    EXPECT_LE(worst_pixel(description, "D65", 47, 1), tolerance) << name;
  }
}

// From the middle of the bubble to rays that touch it, and in any direction.
TEST(Invisible, up_to_the_rim) {
  const color::Spectrum lamp = color::lamp_radiance(*color::find_illuminant("D65"));
  for (const char* name : {"single", "dense", "coincident"}) {
    const bool large_trees = std::string(name) == "coincident";
    const std::vector<double> nm = large_trees ? std::vector<double>{550} : wavelengths(47);
    const scene::Scene scene = testing_scenes::compiled(in_uniform_light(testing_scenes::arrangement(name), "D65"));
    for (const double inset : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 0.0, -1e-15}) {
      if (large_trees && inset > 1e-9) continue;
      const render::ProbeRay ray{{0, 1 - inset, 5}, {0, 0, -1}};
      EXPECT_LE(departure(probed(scene, ray, nm), nm, lamp, 1), tolerance) << name << " at 1 - " << inset;
    }
  }
}

struct Noise {
  double rms = 0;   // of Y against the background
  double own = 0;   // the same estimated from two renders of different seeds
  double mean = 0;  // of Y less the background
};

Noise picture_noise(scene::SceneDesc description) {
  scene::Scene scene = testing_scenes::compiled(description);
  const auto rendered = [&](std::uint64_t seed) {
    scene.render.seed = seed;
    render::Sensor sensor(scene.width, scene.height);
    const auto report = render::render(scene, one_thread, sensor);
    if (!report || report->dropped_samples) throw std::invalid_argument("not rendered whole");
    return sensor;
  };
  const render::Sensor a = rendered(1), b = rendered(2);
  Noise noise;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const double first = a.mean(x, y).y - 1, second = b.mean(x, y).y - 1;
      noise.rms += (first * first + second * second) / 2;
      noise.own += (first - second) * (first - second) / 2;
      noise.mean += (first + second) / 2;
    }
  const double pixels = double(scene.width) * scene.height;
  noise.rms = std::sqrt(noise.rms / pixels), noise.own = std::sqrt(noise.own / pixels), noise.mean /= pixels;
  return noise;
}

// The picture differs from the background by no more than two pictures differ from each other.
TEST(Invisible, in_pictures_within_their_noise) {
  for (const Arrangement& arrangement : testing_scenes::arrangements()) {
    if (!arrangement.lossless) continue;
    scene::SceneDesc description = in_uniform_light(arrangement, "D65");
    description.image = {24, 24};
    description.render.samples = 16;
    const Noise noise = picture_noise(description);
    const double pixels = 24 * 24;
    std::cout << arrangement.name << ": rms of Y " << noise.rms << ", own noise " << noise.own << ", mean "
              << noise.mean << '\n';
    // own^2 is a mean over the pixels: within some ten per cent of what it estimates. Below 1e-6 all is rounding.
    EXPECT_LE(noise.rms, 1.3 * noise.own + 1e-6) << arrangement.name;
    EXPECT_LE(std::abs(noise.mean), 4 * noise.own / std::sqrt(2 * pixels) + 1e-6) << arrangement.name;
  }
}

// Where paths are cut all the time energy is still conserved.
TEST(Invisible, in_pictures_at_any_depth) {
  for (const int depth : {0, 1, 2, 5}) {
    scene::SceneDesc description = in_uniform_light(testing_scenes::arrangement("overlapping"), "D65");
    description.image = {24, 24};
    description.render.samples = 16;
    description.render.max_depth = depth;
    if (!scene::compile(description, {})) continue;  // below the least depth that may be asked for
    const Noise noise = picture_noise(description);
    EXPECT_LE(noise.rms, 1.3 * noise.own + 1e-6) << depth;
  }
}

// How far from invisible the paper's model is: the light through the middle of a bubble and near its rim, over the
// background. The figures stand in docs/paper.md.
TEST(TwoBeam, is_seen_in_uniform_light) {
  const std::vector<double> nm = wavelengths(1);
  const color::Spectrum lamp = color::lamp_radiance(*color::find_illuminant("D65"));
  std::cout << "r/R    smallest  largest  (over wavelength)  Y      linear sRGB\n"
            << std::fixed << std::setprecision(3);
  double largest_of_all = 0, smallest_of_all = 10;
  for (const double radius : {0.0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.999}) {
    scene::SceneDesc description = in_uniform_light(testing_scenes::arrangement("even"), "D65");
    description.objects = {testing_scenes::bubble({0, 0, 0}, 1, "1.3333333333333333", film::ConstantThickness{500})};
    description.render.interference = optics::Interference::two_beam;
    const scene::Scene scene = testing_scenes::compiled(description);
    const std::vector<double> radiance = probed(scene, {{radius, 0, 5}, {0, 0, -1}}, nm);
    double smallest = 10, largest = 0;
    color::Spectrum spectrum;
    for (std::size_t i = 0; i < nm.size(); ++i) {
      smallest = std::min(smallest, radiance[i] / lamp[i]), largest = std::max(largest, radiance[i] / lamp[i]);
      spectrum[i] = radiance[i];
    }
    const color::Xyz xyz = color::radiance_to_xyz(spectrum, color::observer_1931());
    const color::LinearRgb rgb = color::xyz_to_linear_srgb(xyz);
    std::cout << radius << "  " << smallest << "     " << largest << "                       " << xyz.y << "  " << rgb.r
              << ' ' << rgb.g << ' ' << rgb.b << '\n';
    largest_of_all = std::max(largest_of_all, largest), smallest_of_all = std::min(smallest_of_all, smallest);
  }
  EXPECT_GT(largest_of_all, 1.05);
  EXPECT_LT(smallest_of_all, 0.97);
}

}  // namespace
}  // namespace shabon
