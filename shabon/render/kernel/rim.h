// Which pixels lie on a bubble's rim. There the angle of incidence runs through its last degrees within a few pixels,
// the mirrored direction sweeps over half the environment, and nearly all of a picture's noise arises: such pixels get
// more camera samples. The choice depends on the pixel alone, so the mean stays unbiased.
#pragma once

#include <cmath>

#include "shabon/render/kernel/camera_rays.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

inline constexpr int rim_samples = 4;             // camera samples of a rim pixel for each of another
inline constexpr double rim_inside_pixels = 4;    // how far the rim reaches inwards,
inline constexpr double rim_outside_pixels = 1;   // and outwards

// Splits the tile's pixels into plain ones and those on the rim of any sphere.
struct TilePixels {
  std::uint16_t plain[tile_pixels], rim[tile_pixels];
  int plain_count = 0, rim_count = 0;
};

inline TilePixels split_pixels(const scene::Scene& scene, const Tile& tile) {
  using math::Vec3d;
  const scene::Camera& camera = scene.camera;
  const double pixel = math::length(camera.step_x);  // at distance 1, thus the largest angle a pixel has
  const auto direction = [&](double x, double y) { return math::normalize(camera.through(x, y)); };
  const Vec3d middle = direction(tile.x0 + tile.width / 2.0, tile.y0 + tile.height / 2.0);
  const double reach = pixel * tile_size;
  bool on_rim[tile_pixels] = {};
  for (const scene::Sphere& sphere : scene.spheres) {
    const Vec3d to_center = sphere.center - camera.position;
    const double distance = math::length(to_center);
    if (distance <= sphere.radius) continue;  // seen from inside there is no rim
    const double angular_radius = std::asin(sphere.radius / distance);
    const Vec3d axis = to_center * (1 / distance);
    const auto off_axis = [&](const Vec3d& d) { return std::atan2(math::length(math::cross(axis, d)), math::dot(axis, d)); };
    if (std::abs(off_axis(middle) - angular_radius) > reach + rim_inside_pixels * pixel) continue;
    for (int i = 0; i < tile.pixels(); ++i) {
      const Vec3d d = direction(tile.x0 + i % tile.width + 0.5, tile.y0 + i / tile.width + 0.5);
      const double beyond = off_axis(d) - angular_radius;
      on_rim[i] |= beyond > -rim_inside_pixels * pixel && beyond < rim_outside_pixels * pixel;
    }
  }
  TilePixels result;
  for (int i = 0; i < tile.pixels(); ++i) {
    if (on_rim[i])
      result.rim[result.rim_count++] = static_cast<std::uint16_t>(i);
    else
      result.plain[result.plain_count++] = static_cast<std::uint16_t>(i);
  }
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
