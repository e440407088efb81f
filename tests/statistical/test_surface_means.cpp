// The mean of many renders of one tiny pixel is what the probe finds along its ray, summed over the observer, for every
// kind of surface: the renderer's combs of 16 wavelengths and the probe's 471, each with an error of its own.
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "shabon/scene/compile.h"
#include "tests/statistical/z_tests.h"

namespace shabon {
namespace {

constexpr int renders = 20, samples = 256;  // of each: a multiple of the 64 combs
constexpr int probes = 10;                  // of different seeds
constexpr std::size_t probe_samples = 128;  // of each of their wavelengths
// What 64 combs of 16 wavelengths miss of the sum over 471, stated as 1e-4 of the lamp, (28): the lamps here have Y = 1 or
// more. It shows where nothing else is left to chance, as in dark glass of one index.
constexpr double combs_miss = 1e-4, least_lamp = 1;

struct Case {
  const char* name;
  const char* objects;
  const char* more = "";  // of the camera
};

// The camera at (0.3, 0.4, 5) looks at (0.1, -0.05, 0); lamps stand beside and behind it, the floor is below.
const std::vector<Case> cases = {
    {"diffuse under a lamp", "- quad: {rotation_deg: [-70, 0, 0], surface: {diffuse: {color: '#c08040'}}}\n"},
    {"diffuse under a lamp through a film",
     "- quad: {rotation_deg: [-70, 0, 0], surface: {diffuse: {color: 0.8}}}\n"
     "- sphere: {radius: 2.4, surface: {film: {medium: soap, thickness: {linear: {top_nm: 200, bottom_nm: 600}}}}}\n"},
    {"diffuse in a bubble behind a polariser",
     "- quad: {rotation_deg: [-70, 0, 0], surface: {diffuse: {color: 0.8}}}\n"
     "- bubble: {center: [0, 0, 0], radius: 2.4, film: {medium: soap, thickness: {constant_nm: 350}}}\n",
     ", polarizer_deg: 40"},
    {"coated rough metal",
     "- sphere: {radius: 1, surface: {conductor: {stack: 'air | TiO2 80nm | Ti', roughness: 0.3}}}\n"},
    {"anodised metal that varies",
     "- sphere: {radius: 1, surface: {conductor: {stack: 'air | TiO2 80nm | Ti', roughness_map: {file: grey, low: 0.1, "
     "high: 0.6}, vary: {layer: 1, thickness: {map: {file: grey, low_nm: 20, high_nm: 200}}}}}}\n"},
    {"frosted glass", "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | 1.5', roughness: 0.3}}}\n"},
    {"frosted dispersive glass, coated",
     "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | MgF2 99nm | BK7', roughness: 0.15}}}\n"},
    {"dispersive glass", "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | BK7'}}}\n"},
    {"dispersive glass in a polariser", "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | BK7'}}}\n",
     ", polarizer_deg: 70"},
    {"dark glass", "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | 1.5+2e-6i'}}}\n"},
    {"lacquer", "- sphere: {radius: 1, surface: {glossy: {stack: 'air | 1.5', roughness: 0.2, color: '#3060a0'}}}\n"},
    {"oil on a picture",
     "- quad: {rotation_deg: [-60, 0, 0], surface: {glossy: {stack: 'air | 1.47 300nm | water', roughness: 0.05, "
     "color_map: {file: colours}}}}\n"},
    {"pane before a card",
     "- quad: {position: [0, 0, 1], surface: {pane: {stack: 'air | MgF2 99nm | BK7 3mm incoherent | air'}}}\n"
     "- quad: {position: [0, 0, -1], width: 6, height: 6, surface: {diffuse: {color: '#c04040'}}}\n"},
    {"mix",
     "- sphere: {radius: 1, surface: {mix: {amount_map: {file: grey}, surfaces: [{diffuse: {color: 0.6}}, {conductor: "
     "{stack: 'air | Ag', roughness: 0.2}}]}}}\n"},
    {"mask before dispersive glass",
     "- quad: {position: [0, 0, 1.5], surface: {mask: {opacity_map: {file: grey}, surface: {diffuse: {color: "
     "'#40c040'}}}}}\n"
     "- sphere: {radius: 1, surface: {dielectric: {stack: 'air | BK7'}}}\n"},
};

scene::Resources resources() {
  scene::Resources result;
  result.texture = [](const std::string& file) {
    scene::TextureFile texture;
    math::Raster& raster = texture.raster;
    raster.width = 8, raster.height = 4, raster.channels = file == "grey" ? 1 : 3;
    for (int i = 0; i < 32 * raster.channels; ++i) raster.values.push_back(0.15f + 0.7f * float(i * 7 % 11) / 10);
    texture.whole_numbers = true, texture.bits = 16;
    return Result<scene::TextureFile>(texture);
  };
  return result;
}

scene::Scene scene_of(const Case& each) {
  const std::string text =
      "shabon: 1\nmetres_per_unit: 0.01\nimage: {width: 1, height: 1}\n"
      "camera: {position: [0.3, 0.4, 5], look_at: [0.1, -0.05, 0], vertical_fov_deg: 2e-5" +
      std::string(each.more) +
      "}\n"
      "environment: {gradient: {up: {illuminant: D65, scale: 0.6}, down: {illuminant: A, scale: 0.1}}, softboxes: "
      "[{direction: [1, 1, 0.5], half_angle_deg: 20, illuminant: D65, scale: 4}]}\nobjects:\n"
      "- quad: {position: [-3, 2, 2], rotation_deg: [40, 60, 0], surface: {emitter: {illuminant: LED-B3, scale: 6}}}\n"
      "- quad: {position: [0, -3, 0], rotation_deg: [-90, 0, 0], width: 20, height: 20, surface: {diffuse: {color: "
      "0.4}}}\n" +
      each.objects;
  auto scene = scene::load_scene(text, each.name, {}, resources());
  if (!scene) throw std::invalid_argument(to_text(scene.errors()));
  scene->render.samples = samples;
  return *std::move(scene);
}

using Values = std::array<std::vector<double>, 3>;

void push(Values& values, const color::Xyz& xyz) {
  values[0].push_back(xyz.x), values[1].push_back(xyz.y), values[2].push_back(xyz.z);
}

Values rendered(scene::Scene scene) {
  Values values;
  for (int i = 0; i < renders; ++i) {
    scene.render.seed = static_cast<std::uint64_t>(500 + i);
    render::Sensor sensor(1, 1);
    const auto done = render::render(scene, {}, sensor);
    EXPECT_TRUE(done && done->dropped_samples == 0);
    push(values, sensor.mean(0, 0));
  }
  return values;
}

Values probed(const scene::Scene& scene) {
  std::vector<double> nm;
  for (int i = color::first_nm; i <= color::last_nm; ++i) nm.push_back(i);
  Values values;
  for (int i = 0; i < probes; ++i) {
    const auto result = render::probe(scene, render::pixel_ray(scene, 0.5, 0.5), nm,
                                      {probe_samples, static_cast<std::uint64_t>(900 + i)});
    EXPECT_TRUE(result && result->dropped_samples == 0);
    color::Spectrum spectrum;
    std::copy(result->radiance.begin(), result->radiance.end(), spectrum.begin());
    push(values, color::radiance_to_xyz(spectrum, color::observer_1931()));
  }
  return values;
}

TEST(SurfaceMeans, are_what_the_probe_finds) {
  z_tests::Differences differences;
  for (const Case& each : cases) {
    const scene::Scene scene = scene_of(each);
    const Values render = rendered(scene), probe = probed(scene);
    double largest = 0;
    for (const auto& component : probe) largest = std::max(largest, z_tests::estimate(component).mean);
    EXPECT_GT(largest, 0) << each.name;
    std::cout << each.name << ':';
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = z_tests::estimate(render[k]), b = z_tests::estimate(probe[k]);
      const double z = z_tests::z_of_difference(a, b, combs_miss * std::max(largest, least_lamp));
      std::cout << "  " << a.mean << " +- " << a.error << " | " << b.mean << " +- " << b.error << " (" << z << ')';
      differences.add(std::string(each.name) + " " + "XYZ"[k], z);
    }
    std::cout << '\n';
  }
  std::cout << differences.text() << '\n';
  EXPECT_TRUE(differences.agree()) << differences.text();
  EXPECT_LT(differences.mean_square(), 2.5) << differences.text();
}

// Whatever a surface is, some case has it.
TEST(SurfaceMeans, cover_the_list_of_surfaces) {
  std::vector<bool> covered(std::variant_size_v<scene::Surface>);
  for (const Case& each : cases)
    for (const scene::Surface& surface : scene_of(each).surfaces) covered[surface.index()] = true;
  for (std::size_t i = 0; i < covered.size(); ++i) EXPECT_TRUE(covered[i]) << "number " << i << " of the list";
}

}  // namespace
}  // namespace shabon
