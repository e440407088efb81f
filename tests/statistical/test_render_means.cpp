// The mean of many rendered samples of a pixel is the integral of what arrives over the pixel and the observer, as the
// probe or the independent tree has it. The renderer carries 16 wavelengths at a time; the expected value of that is
// the mean over its 64 combs, which is held against the sum over 471 wavelengths by itself. Errors of the mean come
// from renders of different seeds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>

#include "shabon/color/rgb_basis.h"
#include "shabon/render/comb.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "tests/physics/transport/oracle.h"
#include "tests/physics/transport/scenes.h"

namespace shabon {
namespace {

using Colour = std::array<double, 3>;

constexpr int renders = 24;   // of different seeds
constexpr int samples = 256;  // of each: a multiple of the 64 combs
// Student's t with 23 degrees of freedom exceeds it once in 200 000 times: 1e-3 for all comparisons of this file.
constexpr double largest_t = 6.0;
// What float lanes and the size of the pixels may cost, of the pixel's largest component.
constexpr double rounding = 4e-6;
// The pixels are so small that what arrives in their middle is the mean over them; bubbles are strong lenses.
constexpr double tiny_fov_deg = 2e-5;

// A smooth picture with bright spots in linear sRGB; only its name stands in the scene.
io::RgbImage studio() {
  io::RgbImage image;
  image.width = 16, image.height = 8;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.rgb.push_back(static_cast<float>(0.3 + 0.2 * std::sin(0.7 * x + c) * std::cos(0.5 * y * (c + 1)) +
                                               (x % 5 == 1 && y == 2 ? 4 - c : 0)));
  return image;
}

scene::Scene compiled(const scene::SceneDesc& description) {
  scene::Resources resources;
  resources.picture = [](const std::string&) { return Result<io::RgbImage>(studio()); };
  auto scene = scene::compile(description, resources);
  if (!scene) throw std::invalid_argument(scene.errors().front().message);
  return *std::move(scene);
}

scene::EnvironmentDesc picture_light() {
  scene::EnvironmentDesc light;
  light.base = scene::ImageEnvironmentDesc{"studio.hdr", 30, 1};
  return light;
}

// One tiny pixel that looks at `target` from (0.3, 0.4, 5).
scene::SceneDesc pixel_at(const std::string& arrangement, const scene::EnvironmentDesc& light, math::Vec3d target) {
  scene::SceneDesc scene = scene_of(testing_scenes::arrangement(arrangement), light);
  scene.image = {1, 1};
  scene.camera.look_at = target;
  scene.camera.vertical_fov_deg = tiny_fov_deg;
  scene.render.samples = samples;
  return scene;
}

// What arrives along a ray of the camera, per wavelength.
using Arriving = std::function<std::vector<double>(const render::ProbeRay&, const std::vector<double>& nm)>;

Arriving by_probe(const scene::Scene& scene) {
  return [&](const render::ProbeRay& ray, const std::vector<double>& nm) {
    return render::probe(scene, ray, nm).value().radiance;
  };
}

Arriving by_oracle(const scene::SceneDesc& scene) {
  return [&](const render::ProbeRay& ray, const std::vector<double>& nm) {
    oracle::Limits limits;
    limits.least_carried = 0;
    limits.most_events = scene.render.max_depth;
    return oracle::arriving(scene, {ray.origin, ray.direction, true}, nm, limits).radiance;
  };
}

// The expected value of a sample: the mean over all combs.
Colour over_combs(const scene::Scene& scene, const Arriving& arriving) {
  const std::vector<render::Comb> combs = render::wavelength_combs(color::observer_1931(), scene.environment.channels);
  std::vector<double> nm;
  for (const render::Comb& comb : combs)
    for (const double wavelength : comb.wavelength_nm) nm.push_back(std::clamp(wavelength, 360.0, 830.0));
  const std::vector<double> radiance = arriving(render::pixel_ray(scene, 0.5, 0.5), nm);
  Colour sum{};
  std::size_t at = 0;
  for (const render::Comb& comb : combs)
    for (std::size_t lane = 0; lane < comb.wavelength_nm.size(); ++lane, ++at)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += comb.weight[k][lane] * radiance[at] / double(combs.size());
  return sum;
}

Colour over_nanometres(const scene::Scene& scene, const Arriving& arriving) {
  std::vector<double> nm;
  for (int i = color::first_nm; i <= color::last_nm; ++i) nm.push_back(i);
  color::Spectrum spectrum;
  const std::vector<double> radiance = arriving(render::pixel_ray(scene, 0.5, 0.5), nm);
  std::copy(radiance.begin(), radiance.end(), spectrum.begin());
  const color::Xyz xyz = color::radiance_to_xyz(spectrum, color::observer_1931());
  return Colour{xyz.x, xyz.y, xyz.z};
}

struct Estimate {
  Colour mean{}, error{};  // standard error of the mean
};

Estimate rendered(scene::Scene scene) {
  std::vector<Colour> means;
  for (int i = 0; i < renders; ++i) {
    scene.render.seed = static_cast<std::uint64_t>(1000 + i);
    render::RenderOptions options;
    options.threads = 1;
    render::Sensor sensor(1, 1);
    const auto report = render::render(scene, options, sensor);
    EXPECT_TRUE(report.ok() && report->dropped_samples == 0);
    const color::Xyz xyz = sensor.mean(0, 0);
    means.push_back({xyz.x, xyz.y, xyz.z});
  }
  Estimate result;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Colour& m : means) result.mean[k] += m[k] / renders;
    for (const Colour& m : means) result.error[k] += std::pow(m[k] - result.mean[k], 2);
    result.error[k] = std::sqrt(result.error[k] / (renders * (renders - 1.0)));
  }
  return result;
}

struct Summary {
  double largest_t = 0, sum_of_squares = 0, largest_error = 0;
  int comparisons = 0;
};

void compare(const std::string& name, const Estimate& got, const Colour& expected, Summary& summary) {
  const double scale = *std::max_element(expected.begin(), expected.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const double error = std::hypot(got.error[k], rounding * scale), t = (got.mean[k] - expected[k]) / error;
    EXPECT_LE(std::abs(t), largest_t) << name << ", XYZ"[0] << "XYZ"[k] << ": rendered " << got.mean[k] << " +- "
                                      << got.error[k] << ", expected " << expected[k];
    summary.largest_t = std::max(summary.largest_t, std::abs(t));
    summary.largest_error = std::max(summary.largest_error, got.error[k] / scale);
    summary.sum_of_squares += t * t;
    ++summary.comparisons;
  }
}

// The mean square of Student's t with 23 degrees of freedom is 23/21. X, Y and Z of a pixel go together, so that it
// wanders; a small error that all pixels share would raise it.
void report(const char* name, const Summary& s) {
  const double mean_square = s.sum_of_squares / s.comparisons;
  std::cout << name << ": " << s.comparisons << " comparisons, largest |t| " << s.largest_t << ", mean square "
            << mean_square << ", largest relative error of a mean " << s.largest_error << '\n';
  EXPECT_LT(mean_square, 3) << name;
}

void agrees_with(const std::string& name, const scene::SceneDesc& description, Summary& summary) {
  const scene::Scene scene = compiled(description);
  compare(name, rendered(scene), over_combs(scene, by_probe(scene)), summary);
}

TEST(RenderMeans, are_the_integral_over_probes) {
  Summary summary;
  int number = 0;
  for (const char* name :
       {"single", "even", "dense", "overlapping", "three overlapping", "nested", "touching", "air in water", "stacks",
        "absorbing stacks", "gaps in glass", "cluster", "coincident", "absorbing", "concentric"}) {
    const bool large_trees = number >= 24;
    for (const math::Vec3d target : {math::Vec3d{0.31, 0.23, 0}, {-0.55, -0.2, 0.1}}) {
      ++number;
      if (large_trees && number % 2) continue;
      scene::SceneDesc scene =
          pixel_at(name, number % 4 < 2 ? picture_light() : testing_scenes::light("gradient"), target);
      if (number % 3 == 2) scene.camera.polarizer_deg = 30 * number;
      agrees_with(name, scene, summary);
    }
  }
  report("over probes", summary);
}

// Within the last per cent of the radius: R rises to 1, paths go round the bubble many times.
TEST(RenderMeans, are_the_integral_at_the_rim) {
  Summary summary;
  for (const double reach : {0.99, 0.997, 0.9995}) {
    scene::SceneDesc scene = pixel_at("single", picture_light(), {reach, 0, 0});
    scene.camera.position = {reach, 0, 5};
    scene.camera.vertical_fov_deg = tiny_fov_deg * (1 - reach);
    scene.render.max_depth = 1024;
    agrees_with("rim at " + std::to_string(reach), scene, summary);
  }
  report("at the rim", summary);
}

TEST(RenderMeans, of_other_models) {
  Summary summary;
  for (const auto model : {optics::Interference::none, optics::Interference::two_beam}) {
    for (const auto& [name, target] : {std::pair{"single", math::Vec3d{0.45, 0.5, 0}},
                                       {"overlapping", {0.45, 0.5, 0}},
                                       {"absorbing", {0.1, 0.35, 0}}}) {
      scene::SceneDesc scene = pixel_at(name, testing_scenes::light("gradient"), target);
      scene.camera.polarizer_deg = 65;
      scene.render.interference = model;
      agrees_with(std::string(name) + ", " + std::string(optics::name_of(model)), scene, summary);
    }
  }
  report("other models", summary);
}

// Equation (26): the threshold moves noise, never the mean.
TEST(RenderMeans, do_not_depend_on_the_split_threshold) {
  Summary summary;
  scene::SceneDesc scene = pixel_at("overlapping", picture_light(), {0.31, 0.23, 0});
  const scene::Scene whole = compiled(scene);
  const Colour expected = over_combs(whole, by_probe(whole));
  for (const double threshold : {1e-5, 1e-2, 0.3, 1.0}) {
    scene.render.split_threshold = threshold;
    compare("threshold " + std::to_string(threshold), rendered(compiled(scene)), expected, summary);
  }
  report("thresholds", summary);
}

// Equation (27): where max_depth cuts, films pass R + T straight on. The probe knows no such depth; the oracle does.
TEST(RenderMeans, where_the_depth_is_reached) {
  Summary summary;
  for (const char* name : {"single", "dense", "overlapping", "absorbing", "stacks", "absorbing stacks"}) {
    for (const int depth : {1, 3}) {
      scene::SceneDesc scene = pixel_at(name, testing_scenes::light("gradient"), {-0.5, 0.35, 0});
      scene.render.max_depth = depth;
      if (depth == 3) scene.camera.polarizer_deg = 20;
      const scene::Scene whole = compiled(scene);
      compare(std::string(name) + " at depth " + std::to_string(depth), rendered(whole),
              over_combs(whole, by_oracle(scene)), summary);
    }
  }
  report("depths", summary);
}

// What 64 combs of 16 wavelengths miss of the sum over 471: stated as 1e-4 of the lamp, (28).
TEST(RenderMeans, over_combs_are_those_over_nanometres) {
  double worst = 0;
  for (const char* name : {"single", "even", "dense", "cluster"}) {
    for (const math::Vec3d target : {math::Vec3d{0.31, 0.23, 0}, {-0.55, -0.2, 0.1}}) {
      const scene::Scene scene = compiled(pixel_at(name, picture_light(), target));
      const Colour combs = over_combs(scene, by_probe(scene)), whole = over_nanometres(scene, by_probe(scene));
      for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(combs[k] - whole[k]));
    }
  }
  std::cout << "largest difference of the combs " << worst << '\n';
  EXPECT_LE(worst, 1e-4);
}

}  // namespace
}  // namespace shabon
