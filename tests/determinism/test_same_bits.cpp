// A scene and a seed decide the picture to the last bit: not the number of threads, not when it was stopped.

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <set>
#include <thread>

#include "shabon/render/render.h"
#include "tests/physics/transport/scenes.h"

namespace shabon {
namespace {

constexpr int width = 37, height = 21, samples = 36;  // partly filled tiles; passes of 4, 12, 16 and 4 samples

// Passes that end before `samples`, by the number of samples that every pixel then has.
constexpr int pass_ends[] = {4, 16, 32};

// Every kind of surface, textures, lamps of all shapes, a lens and a polariser.
const char* const surfaces = R"(shabon: 1
metres_per_unit: 0.01
camera: {position: [0, 1, 6], look_at: [0, 0, 0], vertical_fov_deg: 40, lens_radius: 0.05, focus_distance: 6, polarizer_deg: 30}
environment: {gradient: {up: {illuminant: D65, scale: 0.5}, down: {illuminant: A, scale: 0.1}}, softboxes: [{direction: [1, 1, 1], half_angle_deg: 9, illuminant: D65, scale: 9}]}
objects:
- quad: {position: [0, -1, 0], rotation_deg: [-90, 0, 0], width: 20, height: 20, surface: {glossy: {stack: "air | 1.47 300nm | water", roughness: 0.1, color_map: {file: colours}}}}
- quad: {position: [-3, 3, 1], rotation_deg: [50, 45, 0], surface: {emitter: {illuminant: LED-B3, scale: 5}}}
- sphere: {position: [2.2, 1.8, 0], radius: 0.3, surface: {emitter: {illuminant: A, scale: 8}}}
- sphere: {position: [-1.6, 0, 0], radius: 0.8, surface: {dielectric: {stack: "air | MgF2 99nm | BK7", roughness: 0.1}}}
- sphere: {position: [0.2, -0.3, -0.5], radius: 0.7, surface: {dielectric: {stack: "air | BK7"}}}
- cylinder: {position: [1.7, 0, 0], radius: 0.6, height: 1.4, surface: {conductor: {stack: "air | TiO2 60nm | Ti", roughness: 0.2, vary: {layer: 1, thickness: {map: {file: grey, low_nm: 20, high_nm: 150}}}}}}
- disk: {position: [0, 1.6, 0.5], radius: 0.6, surface: {film: {medium: soap, thickness: {linear: {top_nm: 100, bottom_nm: 700}}}}}
- quad: {position: [0, 0.2, 1.5], width: 1.5, height: 1, surface: {pane: {stack: "air | MgF2 99nm | BK7 3mm incoherent | air"}}}
- triangle: {corners: [[-2, -1, 1.5], [-0.6, -1, 1.5], [-1.3, 0.3, 1.2]], surface: {mask: {opacity_map: {file: grey}, surface: {diffuse: {color: 0.7}}}}}
- quad: {position: [0, 0, -4], width: 9, height: 4, surface: {mix: {amount: 0.4, surfaces: [{diffuse: {color: "#806040"}}, {conductor: {stack: "air | Ag"}}]}}}
- bubble: {center: [1, 0.4, 1.2], radius: 0.6, film: {medium: soap, thickness: {constant_nm: 400}}}
)";

scene::Scene scene_of_surfaces() {
  scene::Resources resources;
  resources.texture = [](const std::string& file) {
    scene::TextureFile texture;
    math::Raster& raster = texture.raster;
    raster.width = 5, raster.height = 3, raster.channels = file == "grey" ? 1 : 3;
    for (int i = 0; i < 15 * raster.channels; ++i) raster.values.push_back(float(i * 7 % 11) / 10);
    texture.whole_numbers = true, texture.bits = 8;
    return Result<scene::TextureFile>(texture);
  };
  const std::vector<std::string> overrides = {"image.width=" + std::to_string(width),
                                              "image.height=" + std::to_string(height),
                                              "render.samples=" + std::to_string(samples)};
  auto scene = scene::load_scene(surfaces, "surfaces", overrides, resources);
  if (!scene) throw std::invalid_argument(to_text(scene.errors()));
  return *std::move(scene);
}

scene::Scene scene_of(const std::string& arrangement) {
  if (arrangement == "surfaces") return scene_of_surfaces();
  scene::SceneDesc description = scene_of(testing_scenes::arrangement(arrangement), testing_scenes::light("windows"));
  description.image = {width, height};
  description.render.samples = samples;
  if (arrangement == "overlapping") description.camera.polarizer_deg = 20;
  return testing_scenes::compiled(description);
}

struct Outcome {
  render::Sensor sensor{width, height};
  render::RenderReport report;
};

Outcome rendered(const scene::Scene& scene, render::RenderOptions options) {
  Outcome outcome;
  const auto report = render::render(scene, options, outcome.sensor);
  EXPECT_TRUE(report.ok());
  if (report) outcome.report = *report;
  return outcome;
}

Outcome rendered(const scene::Scene& scene, int threads) {
  render::RenderOptions options;
  options.threads = threads;
  return rendered(scene, options);
}

bool same_bits(const render::Sensor::Pixel& a, const render::Sensor::Pixel& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z) && a.samples == b.samples;
}

int different_pixels(const render::Sensor& a, const render::Sensor& b) {
  int count = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) count += !same_bits(a.at(x, y), b.at(x, y));
  return count;
}

TEST(SameBits, for_any_number_of_threads) {
  for (const char* name : {"single", "overlapping", "cluster", "surfaces"}) {
    const scene::Scene scene = scene_of(name);
    const Outcome one = rendered(scene, 1);
    EXPECT_FALSE(one.report.interrupted);
    EXPECT_EQ(one.report.samples_done, samples);
    EXPECT_EQ(one.sensor.sample_range(), (std::pair<std::uint32_t, std::uint32_t>(samples, samples)));
    for (const int threads : {2, 7, 0}) {
      const Outcome many = rendered(scene, threads);
      EXPECT_EQ(different_pixels(one.sensor, many.sensor), 0) << name << ", " << threads << " threads";
      EXPECT_EQ(one.report.film_events, many.report.film_events);
      EXPECT_EQ(one.report.rays, many.report.rays);
    }
  }
}

// More than one thread has a part in it, also where Embree, which uses the same pool, holds the scene.
TEST(Threads, share_the_work) {
  for (const char* name : {"single", "cluster", "surfaces"}) {
    const scene::Scene scene = scene_of(name);
    std::set<std::thread::id> at_work;
    render::RenderOptions options;
    options.threads = 3;
    options.progress = [&](double) {
      at_work.insert(std::this_thread::get_id());
      // Until another thread has come, wait long: on a busy machine one may take all tiles before the rest wake.
      if (at_work.size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(200));
    };
    rendered(scene, options);
    EXPECT_GE(at_work.size(), 2u) << name;
  }
}

TEST(Surfaces, are_all_in_the_scene) {
  std::vector<bool> present(std::variant_size_v<scene::Surface>);
  for (const scene::Surface& surface : scene_of("surfaces").surfaces) present[surface.index()] = true;
  for (std::size_t i = 0; i < present.size(); ++i) EXPECT_TRUE(present[i]) << "number " << i << " of the list";
}

// The single path, too.
TEST(SameBits, of_both_transports) {
  scene::Scene scene = scene_of("surfaces");
  const Outcome tree = rendered(scene, 1);
  scene.render.transport = scene::Transport::path;
  const Outcome one = rendered(scene, 1), two = rendered(scene, 2);
  EXPECT_EQ(different_pixels(one.sensor, two.sensor), 0);
  EXPECT_GT(different_pixels(one.sensor, tree.sensor), width * height / 2);
}

TEST(SameBits, but_not_for_another_seed) {
  for (const char* name : {"single", "surfaces"}) {
    scene::Scene scene = scene_of(name);
    const Outcome first = rendered(scene, 1);
    scene.render.seed = 2;
    const Outcome second = rendered(scene, 1);
    // The background is a softbox or plain light: only pixels that see the bubble, or an edge, differ.
    EXPECT_GT(different_pixels(first.sensor, second.sensor), width * height / 4) << name;
  }
}

TEST(SameBits, another_render_adds_to_the_sensor) {
  for (const char* name : {"single", "surfaces"}) {
    const scene::Scene scene = scene_of(name);
    const Outcome once = rendered(scene, 2);
    render::Sensor twice(width, height);
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(render::render(scene, {}, twice).ok());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        ASSERT_EQ(twice.at(x, y).samples, 2u * samples);
        ASSERT_NEAR(twice.mean(x, y).y, once.sensor.mean(x, y).y, 1e-12 * once.sensor.mean(x, y).y);
      }
  }
}

// Stops when `share` of the work is done; the tile that is being worked on is finished.
Outcome stopped_at(const scene::Scene& scene, int threads, double share) {
  StopFlag stop = false;
  render::RenderOptions options;
  options.threads = threads;
  options.stop = &stop;
  options.progress = [&](double done) {
    if (done >= share) stop = true;
  };
  return rendered(scene, options);
}

// The picture after so many samples, had no more been asked for.
std::vector<Outcome> pass_by_pass(const scene::Scene& scene) {
  std::vector<Outcome> result;
  for (const int end : pass_ends) {
    scene::Scene shorter = scene;
    shorter.render.samples = end;
    result.push_back(rendered(shorter, 1));
  }
  result.push_back(rendered(scene, 1));
  return result;
}

void expect_whole_passes_of(const scene::Scene& scene) {
  const std::vector<Outcome> passes = pass_by_pass(scene);
  for (const int threads : {1, 2, 7}) {
    for (const double share : {0.0, 0.05, 0.3, 0.6, 0.95}) {
      SCOPED_TRACE(testing::Message() << threads << " threads, stopped at " << share);
      const Outcome stopped = stopped_at(scene, threads, share);
      const auto [fewest, most] = stopped.sensor.sample_range();
      EXPECT_TRUE(stopped.report.interrupted);
      EXPECT_EQ(stopped.report.samples_done, static_cast<int>(fewest));
      EXPECT_LT(fewest, static_cast<std::uint32_t>(samples));
      EXPECT_GT(most, 0u);
      std::uint64_t camera_samples = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const render::Sensor::Pixel& pixel = stopped.sensor.at(x, y);
          camera_samples += pixel.samples;
          if (pixel.samples == 0) {
            ASSERT_EQ(pixel.x, 0);
            continue;
          }
          bool found = false;
          for (const Outcome& pass : passes) found |= same_bits(pixel, pass.sensor.at(x, y));
          ASSERT_TRUE(found) << x << ' ' << y << " has " << pixel.samples << " samples";
        }
      EXPECT_LE(camera_samples, stopped.report.camera_samples);  // pixels on a rim get more of them for a sample
    }
  }
}

TEST(SameBits, of_what_an_interrupted_render_finished) {
  for (const char* name : {"overlapping", "surfaces"}) {
    SCOPED_TRACE(name);
    expect_whole_passes_of(scene_of(name));
  }
}

TEST(SameBits, nothing_is_left_out_when_the_stop_comes_too_late) {
  const scene::Scene scene = scene_of("single");
  const Outcome late = stopped_at(scene, 1, 1.0);
  EXPECT_FALSE(late.report.interrupted);
  EXPECT_EQ(late.report.samples_done, samples);
  EXPECT_EQ(different_pixels(late.sensor, rendered(scene, 1).sensor), 0);
}

TEST(SameBits, of_a_render_stopped_before_it_began) {
  const scene::Scene scene = scene_of("single");
  StopFlag stop = true;
  render::RenderOptions options;
  options.stop = &stop;
  const Outcome outcome = rendered(scene, options);
  EXPECT_TRUE(outcome.report.interrupted);
  EXPECT_EQ(outcome.report.samples_done, 0);
  EXPECT_EQ(outcome.report.camera_samples, 0u);
  EXPECT_EQ(outcome.sensor.sample_range().second, 0u);
}

TEST(SameBits, progress_rises_to_its_end) {
  const scene::Scene scene = scene_of("single");
  double last = 0;
  bool rises = true;
  render::RenderOptions options;
  options.threads = 2;
  options.progress = [&](double done) {
    rises &= done >= last;
    last = done;
  };
  rendered(scene, options);
  EXPECT_TRUE(rises);
  EXPECT_EQ(last, 1.0);
}

TEST(SameBits, a_sensor_of_another_size_is_refused) {
  const scene::Scene scene = scene_of("single");
  render::Sensor sensor(width, height + 1);
  EXPECT_FALSE(render::render(scene, {}, sensor).ok());
}

}  // namespace
}  // namespace shabon
