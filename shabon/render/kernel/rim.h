// Which pixels lie on a bubble's rim. There the angle of incidence runs through its last degrees within a few pixels,
// the mirrored direction sweeps over half the environment, and nearly all of a picture's noise arises: such pixels get
// more camera samples. The choice depends on the pixel alone, so the mean stays unbiased.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shabon/render/kernel/camera_rays.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

inline constexpr int rim_samples = 4;            // camera samples of a rim pixel for each of another
inline constexpr double rim_inside_pixels = 4;   // how far the rim reaches inwards,
inline constexpr double rim_outside_pixels = 1;  // and outwards

// A sphere as the camera sees it, and the directions of tile middles that can have its rim in their tile.
struct RimCone {
  math::Vec3d axis;
  double angular_radius;
  double cos_outermost, cos_innermost;
};

// How much further a pixel looks than to its own edges.
inline double filter_reach_pixels(const scene::PixelFilter& filter) {
  return std::max(0.0, filter.width_px() - 1) * (std::numbers::sqrt2 / 2);
}

inline double pixel_angle(const scene::Camera& camera) { return math::length(camera.step_x); }  // the largest of any

inline std::vector<RimCone> rim_cones(const scene::Scene& scene) {
  const double reach = pixel_angle(scene.camera) * (tile_size + rim_inside_pixels + filter_reach_pixels(scene.filter));
  std::vector<RimCone> cones;
  for (const scene::Sphere& sphere : scene.spheres) {
    const math::Vec3d to_center = sphere.center - scene.camera.position;
    const double distance = math::length(to_center);
    if (distance <= sphere.radius) continue;  // seen from inside there is no rim
    const double radius = std::asin(sphere.radius / distance);
    cones.push_back({to_center * (1 / distance), radius, std::cos(std::min(radius + reach, std::numbers::pi)),
                     std::cos(std::max(radius - reach, 0.0))});
  }
  return cones;
}

// Splits the tile's pixels into plain ones and those on the rim of any sphere.
struct TilePixels {
  std::uint16_t plain[tile_pixels], rim[tile_pixels];
  int plain_count = 0, rim_count = 0;
};

inline TilePixels split_pixels(const scene::Scene& scene, const std::vector<RimCone>& cones, const Tile& tile) {
  const scene::Camera& camera = scene.camera;
  const double pixel = pixel_angle(camera), further = filter_reach_pixels(scene.filter);
  const double inside = (rim_inside_pixels + further) * pixel, outside = (rim_outside_pixels + further) * pixel;
  const auto direction = [&](double x, double y) { return math::normalize(camera.through(x, y)); };
  const math::Vec3d middle = direction(tile.x0 + tile.width / 2.0, tile.y0 + tile.height / 2.0);
  bool on_rim[tile_pixels] = {};
  for (const RimCone& cone : cones) {
    const double cosine = math::dot(cone.axis, middle);
    if (cosine < cone.cos_outermost || cosine > cone.cos_innermost) continue;
    for (int i = 0; i < tile.pixels(); ++i) {
      const int column = i % tile.width, row = i / tile.width;
      const math::Vec3d d = direction(tile.x0 + column + 0.5, tile.y0 + row + 0.5);
      const double off_axis = std::atan2(math::length(math::cross(cone.axis, d)), math::dot(cone.axis, d));
      const double beyond = off_axis - cone.angular_radius;
      on_rim[i] |= beyond > -inside && beyond < outside;
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
