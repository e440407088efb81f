// What cameras and pixel filters do to pictures: projections, the lens's blur, the profile of a small lamp, the
// polariser. Both kernels where both can see the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shabon/render/probe.h"
#include "shabon/render/render.h"
#include "tests/physics/transport/scenes.h"

namespace shabon {
namespace {

using math::Vec3d;
using scene::SceneDesc;

// Y of each pixel.
struct Luminances {
  int width = 0, height = 0;
  std::vector<double> y;
  double at(int column, int row) const { return y[static_cast<std::size_t>(row * width + column)]; }
  double sum() const {
    double total = 0;
    for (const double value : y) total += value;
    return total;
  }
};

Luminances rendered(const scene::Scene& scene) {
  render::Sensor sensor(scene.width, scene.height);
  const auto done = render::render(scene, {}, sensor);
  EXPECT_TRUE(done.ok());
  EXPECT_EQ(done.ok() ? done->dropped_samples : 1, 0u);
  Luminances result{scene.width, scene.height, {}};
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) result.y.push_back(sensor.mean(x, y).y);
  return result;
}

Luminances rendered(const SceneDesc& description) { return rendered(testing_scenes::compiled(description)); }

SceneDesc dark_scene(int width, int height, int samples) {
  SceneDesc description;
  description.image.width = width, description.image.height = height;
  description.render.samples = samples;
  description.environment = testing_scenes::uniform("D65", 0);
  return description;
}

// The kernel of the bubbles, or, by a lens too small to matter, the general one.
enum class Kernel { bubbles, general };
constexpr Kernel kernels[] = {Kernel::bubbles, Kernel::general};
void choose(Kernel kernel, scene::Scene& scene) {
  if (kernel == Kernel::general) scene.camera.lens_radius = 1e-12;
}
const char* name_of(Kernel kernel) { return kernel == Kernel::bubbles ? "bubbles" : "general"; }

// Light that is a function of the direction alone: what each projection's pixels look at.
TEST(Projections, pixels_see_what_lies_in_their_direction) {
  for (const scene::ProjectionEntry& entry : scene::projections) {
    SceneDesc description = dark_scene(24, 12, 16);
    description.environment.base = scene::GradientEnvironmentDesc{{"D65", 2}, {"D65", 0}};
    description.camera.position = {0, -2, 5};
    description.camera.projection = entry.name;
    const scene::Scene scene = testing_scenes::compiled(description);
    const Luminances picture = rendered(scene);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 24; ++x) {
        double expected = 0;
        for (int i = 0; i < 8; ++i)
          for (int j = 0; j < 8; ++j)
            expected += 1 + scene.camera.ray(x + (i + 0.5) / 8, y + (j + 0.5) / 8).direction.y;
        EXPECT_NEAR(picture.at(x, y), expected / 64, 4e-3) << entry.name << ' ' << x << ' ' << y;
      }
  }
}

// Films without loss under even light cannot be seen, and a polariser takes half of it.
TEST(Projections, even_light_stays_even_and_a_polariser_takes_half) {
  for (const scene::ProjectionEntry& entry : scene::projections)
    for (const double lens_radius : {0.0, 0.4})
      for (const bool polarizer : {false, true}) {
        if (lens_radius > 0 && !entry.has_lens) continue;
        SceneDesc description =
            testing_scenes::scene_of(testing_scenes::arrangement("cluster"), testing_scenes::uniform("D65", 1));
        description.image.width = 16, description.image.height = 8;
        description.render.samples = 8;
        description.camera.vertical_fov_deg.reset();
        description.camera.projection = entry.name;
        description.camera.lens_radius = lens_radius;
        if (polarizer) description.camera.polarizer_deg = 30;
        const Luminances picture = rendered(description);
        const double expected = polarizer ? 0.5 : 1;
        SCOPED_TRACE(testing::Message() << entry.name << ' ' << lens_radius << ' ' << polarizer);
        EXPECT_NEAR(picture.sum() / double(picture.y.size()), expected, 1e-3);
        for (const double y : picture.y) EXPECT_NEAR(y, expected, 2e-2);
      }
}

// A glass floor at Brewster's angle, light from above: along p nothing is reflected.
TEST(Projections, a_polariser_extinguishes_the_reflection_at_brewsters_angle) {
  constexpr double n = 1.5;
  for (const scene::ProjectionEntry& entry : scene::projections) {
    const bool pinhole = entry.projection == scene::Projection::perspective;
    for (const double axis_deg : {0.0, 90.0}) {
      SceneDesc description = dark_scene(2, 2, 64);
      description.environment.softboxes.push_back({{"D65", 1}, {0, 1, 0}, scene::RoundShapeDesc{90}});
      scene::DielectricSurfaceDesc glass;
      glass.stack = "air | 1.5";
      description.objects = {scene::QuadDesc{{{0, 0, 0}, {-90, 0, 0}}, 100, 100, {glass}}};
      description.camera.position = {0, 1, n};  // tan of the angle of incidence is n
      description.camera.look_at = {0, 0, 0};
      description.camera.projection = entry.name;
      description.camera.polarizer_deg = axis_deg;
      if (pinhole) description.camera.vertical_fov_deg = 0.01;
      if (entry.projection == scene::Projection::orthographic) description.camera.orthographic_height = 0.1;
      scene::Scene scene = testing_scenes::compiled(description);
      double light = 0;
      if (entry.projection == scene::Projection::panorama) {
        // Its pixels are wide: only the middle one of a picture so large that it is narrow.
        const render::ProbeRay ray = render::pixel_ray(scene, 1, 1);
        scene.camera = scene::look_at_camera(ray.origin, ray.origin + ray.direction, {0, 1, 0}, 1e-4, 2, 2);
        scene.camera.polarizer_rad = axis_deg * std::numbers::pi / 180;
      }
      light = rendered(scene).sum() / 4;
      const double reflected_s = std::pow((n * n - 1) / (n * n + 1), 2);
      EXPECT_NEAR(light, axis_deg == 0 ? reflected_s / 2 : 0, 1e-4) << entry.name << ' ' << axis_deg;
    }
  }
}

// A small disk that shines, on the axis of the camera, `distance` away from it.
SceneDesc lamp_at(double distance, double radius, std::string_view projection, int samples) {
  SceneDesc description = dark_scene(40, 40, samples);
  description.camera.position = {0, 0, 5};
  description.camera.look_at = {0, 0, 0};
  description.camera.projection = projection;
  if (projection == "perspective") description.camera.vertical_fov_deg = 12;
  if (projection == "orthographic") description.camera.orthographic_height = 0.9;
  scene::EmitterSurfaceDesc lamp;
  lamp.scale = 1;
  description.objects = {scene::DiskDesc{{{0, 0, 5 - distance}}, radius, 0, {lamp}}};
  return description;
}

double mean_square_radius(const Luminances& picture) {
  double sum = 0, square = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double right = x + 0.5 - picture.width / 2.0, down = y + 0.5 - picture.height / 2.0;
      sum += picture.at(x, y), square += picture.at(x, y) * (right * right + down * down);
    }
  return square / sum;
}

// The image of a disk of radius a, blurred by a disk of radius c and by the pixels, has the mean square radius
// a^2/2 + c^2/2 + 1/6, and ends sharply.
TEST(DepthOfField, the_circle_of_confusion_is_that_of_a_thin_lens) {
  constexpr double lens = 0.25, focus = 5, lamp = 0.03;
  for (const scene::ProjectionEntry& entry : scene::projections) {
    if (!entry.has_lens) continue;
    for (const double distance : {2.5, 4.0, 5.0, 8.0}) {
      SceneDesc description = lamp_at(distance, lamp, entry.name, 1024);
      scene::Scene scene = testing_scenes::compiled(description);
      const double pixel = math::length(scene.camera.step_x);  // of the plane at distance 1, or of any
      const bool perspective = entry.projection == scene::Projection::perspective;
      // By similar triangles: on the sharp plane, or, in parallel projection, in the lamp's own.
      const double blur = perspective ? lens * std::abs(distance - focus) / distance / focus / pixel
                                      : lens * std::abs(distance - focus) / focus / pixel;
      const double image = perspective ? lamp / distance / pixel : lamp / pixel;
      const Luminances sharp = rendered(scene);
      scene.camera.lens_radius = lens;
      const Luminances blurred = rendered(scene);
      SCOPED_TRACE(testing::Message() << entry.name << ", lamp at " << distance << ", blur " << blur << " pixels");
      ASSERT_LT(blur + image + 1, 20);
      EXPECT_NEAR(sharp.sum(), std::numbers::pi * image * image, 0.02 * sharp.sum());
      EXPECT_NEAR(blurred.sum(), sharp.sum(), 0.03 * sharp.sum());
      const double expected = (image * image + blur * blur) / 2 + 1.0 / 6;
      if (blur > 1) {  // narrower ones depend on where in its pixel the lamp is
        EXPECT_NEAR(mean_square_radius(blurred), expected, 0.03 * expected + 0.03);
      }
      double outside = 0, inside = 0;
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
          const double radius = std::hypot(x - 19.5, y - 19.5);
          if (radius > blur + image + 0.71) outside += blurred.at(x, y);
          if (blur > image + 2 && radius > blur - image - 2 && radius < blur - image - 0.71) inside += blurred.at(x, y);
        }
      EXPECT_EQ(outside, 0);
      EXPECT_EQ(inside > 0, blur > image + 2);
    }
  }
}

TEST(DepthOfField, what_is_at_the_focus_distance_stays_sharp) {
  for (const scene::ProjectionEntry& entry : scene::projections) {
    if (!entry.has_lens) continue;
    SceneDesc description = lamp_at(7, 0.3, entry.name, 256);
    description.camera.focus_distance = 7;
    const Luminances sharp = rendered(description);
    description.camera.lens_radius = 1;
    const Luminances through_lens = rendered(description);
    for (std::size_t i = 0; i < sharp.y.size(); ++i) ASSERT_NEAR(through_lens.y[i], sharp.y[i], 2e-3) << entry.name;
    description.camera.focus_distance = 6;
    const Luminances off = rendered(description);
    double difference = 0;
    for (std::size_t i = 0; i < sharp.y.size(); ++i) difference = std::max(difference, std::abs(off.y[i] - sharp.y[i]));
    EXPECT_GT(difference, 0.1) << entry.name;
  }
}

// A round lamp of a radius of some pixels at infinity around the point (x, y) of a picture.
scene::Scene small_lamp(double x, double y, double radius_px, int size, int samples, const scene::PixelFilter& filter,
                        Kernel kernel) {
  SceneDesc description = dark_scene(size, size, samples);
  description.camera.vertical_fov_deg = 20;  // lamps wide enough for directions in float
  const scene::Camera camera = testing_scenes::compiled(description).camera;
  const double half_angle_deg = std::atan(radius_px * math::length(camera.step_x)) * 180 / std::numbers::pi;
  description.environment.softboxes.push_back(
      {{"D65", 1}, camera.ray(x, y).direction, scene::RoundShapeDesc{half_angle_deg}});
  scene::Scene scene = testing_scenes::compiled(description);
  scene.filter = filter;
  choose(kernel, scene);
  return scene;
}

// The share of a pixel's filter that a round lamp covers.
double covered(const scene::PixelFilter& filter, double x, double y, double radius_px) {
  constexpr int steps = 200;
  double sum = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double right = (2 * (i + 0.5) / steps - 1) * radius_px, down = (2 * (j + 0.5) / steps - 1) * radius_px;
      if (right * right + down * down < radius_px * radius_px)
        sum += filter.density(x + right) * filter.density(y + down);
    }
  return sum * std::pow(2 * radius_px / steps, 2);
}

// A small lamp's picture is the filter itself.
TEST(PixelFilters, a_small_lamp_draws_the_filter) {
  constexpr int size = 7, samples = 4096;
  constexpr double x = 3.8, y = 3.35, radius = 0.2;
  for (const scene::FilterEntry& entry : scene::pixel_filters)
    for (const Kernel kernel : kernels) {
      const scene::PixelFilter filter(entry.kind);
      const Luminances picture = rendered(small_lamp(x, y, radius, size, samples, filter, kernel));
      for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
          const double share = covered(filter, x - column - 0.5, y - row - 0.5, radius);
          const double sigma = std::sqrt(share * (1 - share) / samples);  // were the samples independent
          EXPECT_NEAR(picture.at(column, row), share, 5 * sigma + 1e-4)
              << entry.name << ", " << name_of(kernel) << " kernel, " << column << ' ' << row;
        }
    }
}

// Whatever the filter, the light of a lamp of some pixels arrives, no more and no less.
TEST(PixelFilters, keep_the_light_of_a_lamp) {
  constexpr int size = 24, samples = 256;
  constexpr double radius = 3.3;
  for (const scene::FilterEntry& entry : scene::pixel_filters)
    for (const double width_px : {entry.default_width_px, 5.0})
      for (const Kernel kernel : kernels) {
        const scene::PixelFilter filter(entry.kind, width_px);
        const Luminances picture = rendered(small_lamp(12.3, 11.6, radius, size, samples, filter, kernel));
        const double area = std::numbers::pi * radius * radius;
        EXPECT_NEAR(picture.sum(), area, 5e-3 * area) << entry.name << ' ' << width_px << ' ' << name_of(kernel);
      }
}

// Where pixels look further than their edges a bubble's rim is still sampled for what it is: both kernels agree.
TEST(PixelFilters, a_rim_looks_the_same_to_both_kernels) {
  for (const scene::FilterEntry& entry : scene::pixel_filters) {
    SceneDesc description =
        testing_scenes::scene_of(testing_scenes::arrangement("single"), testing_scenes::light("windows"));
    description.image.width = description.image.height = 24;
    description.image.pixel_filter = entry.name;
    description.image.filter_width_px = 6;
    description.render.samples = 64;
    Luminances pictures[2][2];
    for (const Kernel kernel : kernels)
      for (const std::uint64_t seed : {0, 1}) {
        description.render.seed = 10 * static_cast<std::uint64_t>(kernel) + seed;
        scene::Scene scene = testing_scenes::compiled(description);
        choose(kernel, scene);
        pictures[static_cast<int>(kernel)][seed] = rendered(scene);
      }
    double between = 0, within = 0;
    for (std::size_t i = 0; i < pictures[0][0].y.size(); ++i) {
      const double a = pictures[0][0].y[i], b = pictures[0][1].y[i], c = pictures[1][0].y[i], d = pictures[1][1].y[i];
      between += std::pow((a + b) / 2 - (c + d) / 2, 2);
      within += (std::pow(a - b, 2) + std::pow(c - d, 2)) / 4;
    }
    // Of equal means both have the same expected value; over 576 pixels the quotient stays near 1.
    EXPECT_LT(between, 1.5 * within) << entry.name;
    EXPECT_GT(within, 0);
  }
}

}  // namespace
}  // namespace shabon
