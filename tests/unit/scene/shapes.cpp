// Where the shapes of a scene file stand.
#include <gtest/gtest.h>

#include <cmath>

#include "shabon/scene/compile.h"
#include "shabon/scene/compile_objects.h"

namespace shabon::scene {
namespace {

using math::Vec3d;

geometry::PlacedShape load(const std::string& shape) {
  const std::string text = "shabon: 1\nenvironment: {constant: {}}\nobjects:\n  - " + shape + "\n";
  const Result<Scene> scene = load_scene(text, "test.yaml", {}, {});
  EXPECT_TRUE(scene.ok()) << to_text(scene.errors());
  EXPECT_TRUE(!scene || scene->objects.size() == 1);
  return scene ? scene->objects.at(0).shape : geometry::place(geometry::Quad{}, {});
}

// Where a point of the canonical shape is in the world.
void expect_at(const geometry::PlacedShape& shape, Vec3d canonical, Vec3d world) {
  const Vec3d p = geometry::apply_point(shape.to_world, canonical);
  EXPECT_NEAR(math::length(p - world), 0, 1e-12) << p.x << " " << p.y << " " << p.z;
}

TEST(Shapes, a_sphere_has_its_radius_and_cap) {
  const auto shape = load("sphere: {position: [1, 2, 3], radius: 2, cap_deg: 60, surface: {diffuse: {}}}");
  expect_at(shape, {0, 1, 0}, {1, 4, 3});
  EXPECT_NEAR(std::get<geometry::SphereCap>(shape.shape).cos_cap, 0.5, 1e-15);
  EXPECT_TRUE(std::get<geometry::SphereCap>(load("sphere: {surface: {diffuse: {}}}").shape).is_whole());
}

TEST(Shapes, are_scaled_then_turned_about_x_then_y_then_z_then_moved) {
  const auto shape = load(
      "quad: {position: [10, 0, 0], rotation_deg: [90, 90, 0], scale: [1, 3, 1], width: 4, height: 2, surface: "
      "{diffuse: "
      "{}}}");
  // The quad's upper edge: y = 1, times half of its height and the scale, 3; about x to z = 3, about y to x = 3.
  expect_at(shape, {0, 1, 0}, {13, 0, 0});
  // Its right edge: x = 2; about x the same, about y to z = -2.
  expect_at(shape, {1, 0, 0}, {10, 0, -2});
}

TEST(Shapes, a_ring_keeps_the_share_of_its_hole) {
  const auto shape = load("disk: {radius: 4, hole_radius: 1, rotation_deg: [-90, 0, 0], surface: {diffuse: {}}}");
  EXPECT_EQ(std::get<geometry::Disk>(shape.shape).hole, 0.25);
  expect_at(shape, {0, 0, 1}, {0, 4, 0});  // its front faces upwards
  EXPECT_NEAR(geometry::area(shape), 15 * std::numbers::pi, 1e-9);
}

TEST(Shapes, a_tube_stands_upright) {
  const auto shape = load("cylinder: {radius: 0.5, height: 6, surface: {diffuse: {}}}");
  expect_at(shape, {1, 1, 0}, {0.5, 3, 0});
  EXPECT_NEAR(geometry::area(shape), 6 * std::numbers::pi, 1e-9);
}

TEST(Shapes, a_torus_lies_level) {
  const auto shape = load("torus: {radius: 2, tube_radius: 0.5, position: [0, 1, 0], surface: {diffuse: {}}}");
  EXPECT_EQ(std::get<geometry::Torus>(shape.shape).tube, 0.25);
  expect_at(shape, {1, 0.25, 0}, {2, 1.5, 0});
  EXPECT_NEAR(geometry::area(shape), 4 * std::numbers::pi * std::numbers::pi, 1e-9);
}

TEST(Shapes, a_triangle_has_its_corners_and_its_front) {
  const auto shape = load("triangle: {corners: [[1, 0, 0], [3, 0, 0], [1, 0, -4]], surface: {diffuse: {}}}");
  expect_at(shape, {0, 0, 0}, {1, 0, 0});
  expect_at(shape, {1, 0, 0}, {3, 0, 0});
  expect_at(shape, {0, 1, 0}, {1, 0, -4});
  EXPECT_NEAR(geometry::apply_normal(shape.to_world, {0, 0, 1}).y, 1, 1e-12);
  EXPECT_NEAR(geometry::area(shape), 4, 1e-12);
}

TEST(Shapes, a_description_written_in_code_is_checked_alike) {
  SceneDesc description;
  TriangleDesc triangle;
  triangle.corners.clear();
  triangle.surface.chosen = DiffuseSurfaceDesc{};
  SphereDesc sphere;
  sphere.scale = {1, std::nan(""), 1};
  sphere.surface.chosen = MixSurfaceDesc{};
  description.objects = {triangle, sphere};
  const Result<Scene> scene = compile(description, {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(to_text(scene.errors()),
            "error: objects[0].triangle.corners: expected 3 items, got 0\n"
            "error: objects[1].sphere.scale[1]: expected a finite number, got nan\n"
            "error: objects[1].sphere.surface.mix.surfaces: expected 2 items, got 0\n");
}

}  // namespace
}  // namespace shabon::scene
