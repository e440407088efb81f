// Each projection's rays against its closed form.
#include "shabon/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "shabon/scene/compile.h"
#include "shabon/scene/lights/image_light.h"

namespace shabon::scene {
namespace {

using math::Vec3d;

constexpr int width = 200, height = 100;

SceneDesc description_with(std::string_view projection) {
  SceneDesc description;
  description.image.width = width, description.image.height = height;
  description.camera.position = {1, 2, 3};
  description.camera.look_at = {-0.5, 1, -2};
  description.camera.up = {0.2, 1, 0.1};
  description.camera.projection = projection;
  return description;
}

Camera compiled_camera(const SceneDesc& description) {
  const auto scene = compile(description, Resources{});
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.errors().front().message);
  return scene.ok() ? scene->camera : Camera{};
}

Camera camera_with(std::string_view projection) { return compiled_camera(description_with(projection)); }

// What a ray of the frame's point (x, y) must be, x and y from -1 to 1, right and up.
struct Expected {
  std::string_view projection;
  std::function<CameraRay(const Camera&, double x, double y)> ray;
};

std::vector<Expected> closed_forms() {
  const double tan_half = std::tan(default_vertical_fov_deg / 2 * std::numbers::pi / 180);
  const double aspect = double(width) / height;
  return {{"perspective",
           [=](const Camera& c, double x, double y) {
             return CameraRay{c.position,
                              math::normalize(c.forward + c.right * (x * aspect * tan_half) + c.up * (y * tan_half))};
           }},
          {"orthographic",
           [=](const Camera& c, double x, double y) {
             const double half = default_orthographic_height / 2;
             return CameraRay{c.position + c.right * (x * aspect * half) + c.up * (y * half), c.forward};
           }},
          {"panorama", [](const Camera& c, double x, double y) {
             const double longitude = x * std::numbers::pi, latitude = y * std::numbers::pi / 2;
             return CameraRay{c.position,
                              (c.forward * std::cos(longitude) + c.right * std::sin(longitude)) * std::cos(latitude) +
                                  c.up * std::sin(latitude)};
           }}};
}

TEST(Camera, every_projection_has_its_closed_form) {
  for (const ProjectionEntry& entry : projections) {
    const auto forms = closed_forms();
    const auto form = std::find_if(forms.begin(), forms.end(), [&](auto& f) { return f.projection == entry.name; });
    ASSERT_NE(form, forms.end()) << entry.name;
    const Camera camera = camera_with(entry.name);
    EXPECT_EQ(camera.projection, entry.projection);
    for (const double x : {-1.0, -0.37, 0.0, 0.5, 1.0})
      for (const double y : {-1.0, -0.5, 0.0, 0.81, 1.0}) {
        const CameraRay ray = camera.ray((x + 1) / 2 * width, (1 - y) / 2 * height), expected = form->ray(camera, x, y);
        EXPECT_LT(math::length(ray.origin - expected.origin), 1e-14) << entry.name << ' ' << x << ' ' << y;
        EXPECT_LT(math::length(ray.direction - expected.direction), 1e-14) << entry.name << ' ' << x << ' ' << y;
      }
  }
}

TEST(Camera, a_panorama_needs_no_target) {
  SceneDesc description = description_with("panorama");
  description.camera.look_at.reset();
  for (const Vec3d& position : {Vec3d{0, 0, 0}, Vec3d{0, 7, 0}, Vec3d{1, 2, 3}}) {
    description.camera.position = position;
    description.camera.up = {0, 1, 0};
    EXPECT_LT(math::length(compiled_camera(description).forward - Vec3d{0, 0, -1}), 1e-12);
    description.camera.up = {0, 0, -2};
    EXPECT_LT(math::length(compiled_camera(description).forward - Vec3d{1, 0, 0}), 1e-12);
  }
  description.camera.projection = "perspective";
  description.camera.position = {0, 0, 0};
  EXPECT_FALSE(compile(description, Resources{}));
}

TEST(Camera, the_middle_looks_at_the_target_and_the_frame_is_right_handed) {
  for (const ProjectionEntry& entry : projections) {
    const SceneDesc description = description_with(entry.name);
    const Camera camera = compiled_camera(description);
    const CameraRay ray = camera.ray(width / 2.0, height / 2.0);
    const Vec3d view = description.camera.target() - description.camera.position;
    EXPECT_LT(math::length(ray.direction - math::normalize(view)), 1e-14) << entry.name;
    EXPECT_NEAR(camera.focus_distance, math::length(view), 1e-14);
    EXPECT_LT(math::length(math::cross(camera.right, camera.up) + camera.forward), 1e-14);
    EXPECT_GT(math::dot(camera.up, description.camera.up), 0);
  }
}

// Where a point of the scene appears, by bisection of a line of the picture: a straight line stays straight.
TEST(Camera, straight_lines_stay_straight) {
  for (const std::string_view name : {"perspective", "orthographic"}) {
    const Camera camera = camera_with(name);
    // Three points of the picture on one line: their rays and a fourth point on the first two rays lie in one plane.
    const CameraRay a = camera.ray(20, 10), b = camera.ray(100, 40), c = camera.ray(180, 70);
    const Vec3d start = a.origin + a.direction * 2.0, along = b.origin + b.direction * 7.0 - start;
    // The line through a point of each of the first two rays meets the third.
    const Vec3d apart = c.origin - start;
    const double volume = math::dot(apart, math::cross(along, c.direction));
    EXPECT_LT(std::abs(volume), 1e-13) << name;
    const CameraRay off = camera.ray(180, 71);
    EXPECT_GT(std::abs(math::dot(off.origin - start, math::cross(along, off.direction))), 1e-4) << name;
  }
}

// A panorama sees the environment picture texel by texel when it looks along -z.
TEST(Camera, a_panorama_is_the_environment_picture) {
  auto picture = std::make_shared<EnvironmentPicture>();
  picture->width = width, picture->height = height;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int row = 0; row < height; ++row) {
    const std::size_t first = picture->texels.size();
    for (int column = 0; column < width; ++column)
      for (int c = 0; c < 4; ++c) picture->texels.push_back(uniform(random));
    for (std::size_t c = 0; c < 4; ++c) picture->texels.push_back(picture->texels[first + c]);
  }
  const ImageLight light{picture, 0, 0, 1};
  const Camera camera = panorama_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, width, height);
  for (int y = 0; y < height; y += 7)
    for (int x = 0; x < width; x += 3) {
      double rgb[3] = {};
      light.add(camera.ray(x + 0.5, y + 0.5).direction, rgb);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], picture->texel(x, y)[c], 1e-9) << x << ' ' << y;
    }
}

TEST(Camera, the_square_covers_the_lens_evenly) {
  constexpr int n = 400;
  double count = 0, square = 0, quadrant = 0, inner = 0, mean_right = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const LensPoint p = lens_point((i + 0.5) / n, (j + 0.5) / n);
      const double r2 = p.right * p.right + p.up * p.up;
      EXPECT_LE(r2, 1 + 1e-12);
      count += 1, square += r2, mean_right += p.right;
      quadrant += p.right > 0 && p.up > 0, inner += r2 < 0.25;
    }
  EXPECT_NEAR(square / count, 0.5, 1e-5);  // mean square radius of the unit disk
  EXPECT_NEAR(quadrant / count, 0.25, 2e-3);
  EXPECT_NEAR(inner / count, 0.25, 2e-3);
  EXPECT_NEAR(mean_right / count, 0, 1e-12);
  const LensPoint middle = lens_point(0.5, 0.5);
  EXPECT_EQ(middle.right, 0);
  EXPECT_EQ(middle.up, 0);
}

// All rays of a point of the picture meet in the sharp plane; elsewhere they spread over the lens's image.
TEST(Camera, rays_through_the_lens_meet_at_the_focus) {
  for (const ProjectionEntry& entry : projections) {
    if (!entry.has_lens) continue;
    SceneDesc description = description_with(entry.name);
    description.camera.lens_radius = 0.3;
    description.camera.focus_distance = 4;
    const Camera camera = compiled_camera(description);
    EXPECT_FALSE(camera.is_pinhole());
    EXPECT_FALSE(camera.rays_begin_in_one_point());
    const auto in_plane = [&](const CameraRay& ray, double depth) {
      const double reach =
          (depth - math::dot(ray.origin - camera.position, camera.forward)) / math::dot(ray.direction, camera.forward);
      return ray.origin + ray.direction * reach;
    };
    const CameraRay chief = camera.ray(13.5, 88);
    for (const LensPoint lens : {LensPoint{1, 0}, {0, 1}, {-0.6, 0.8}, {0.1, -0.2}}) {
      const CameraRay ray = camera.ray(13.5, 88, lens);
      const Vec3d aside = camera.right * (0.3 * lens.right) + camera.up * (0.3 * lens.up);
      EXPECT_LT(math::length(ray.origin - chief.origin - aside), 1e-14) << entry.name;
      EXPECT_NEAR(math::length(ray.direction), 1, 1e-14);
      EXPECT_LT(math::length(in_plane(ray, 4) - in_plane(chief, 4)), 1e-13) << entry.name;
      EXPECT_LT(math::length(in_plane(ray, 2) - in_plane(chief, 2) - aside * 0.5), 1e-13) << entry.name;
      EXPECT_LT(math::length(in_plane(ray, 12) - in_plane(chief, 12) + aside * 2.0), 1e-13) << entry.name;
    }
  }
}

// Image right made normal to the ray, wherever the ray goes.
TEST(Camera, the_polariser_counts_from_image_right) {
  for (const ProjectionEntry& entry : projections) {
    const Camera camera = camera_with(entry.name);
    for (int y = 0; y <= height; y += 10)
      for (int x = 0; x <= width; x += 10) {
        const Vec3d d = camera.ray(x, y).direction, s = camera.polarizer_right(d);
        ASSERT_NEAR(math::length(s), 1, 1e-12) << entry.name << ' ' << x << ' ' << y;
        ASSERT_NEAR(math::dot(s, d), 0, 1e-12) << entry.name << ' ' << x << ' ' << y;
        ASSERT_GE(math::dot(s, camera.right), -1e-12) << entry.name << ' ' << x << ' ' << y;
      }
    const Vec3d sideways = camera.polarizer_right(camera.right);
    EXPECT_NEAR(math::dot(sideways, camera.right), 0, 1e-12);
    EXPECT_NEAR(math::length(sideways), 1, 1e-12);
  }
}

TEST(Camera, only_a_perspective_without_a_lens_is_a_pinhole) {
  for (const ProjectionEntry& entry : projections) {
    SceneDesc description = description_with(entry.name);
    EXPECT_EQ(compiled_camera(description).is_pinhole(), entry.projection == Projection::perspective);
    EXPECT_EQ(compiled_camera(description).rays_begin_in_one_point(), entry.projection != Projection::orthographic);
  }
}

}  // namespace
}  // namespace shabon::scene
