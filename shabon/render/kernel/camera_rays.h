// The first generation: one path for each of some pixels of a tile, for one sample number, all on the same wavelength
// comb.
#pragma once

#include "shabon/render/kernel/paths.h"
#include "shabon/render/sampling.h"
#include "shabon/scene/scene.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

struct Tile {
  int x0, y0, width, height;  // width, height <= tile_size
  int pixels() const { return width * height; }
};

// What a path carries before its first event: all of unpolarised light, or half behind an ideal polariser.
struct CameraStart {
  explicit CameraStart(const scene::Scene& scene) {
    const auto& angle = scene.camera.polarizer_rad;
    carried = angle ? 0.5f : 1.0f;
    // The paper's film averages the polarisations: a polariser then only halves.
    polarized = angle && scene.render.interference != optics::Interference::two_beam;
    if (polarized) cos_2a = static_cast<float>(std::cos(2 * *angle)), sin_2a = static_cast<float>(std::sin(2 * *angle));
  }
  float carried = 1, cos_2a = 1, sin_2a = 0;
  bool polarized = false;
};

// The row behind a polariser, in the frame whose s axis is the camera's right, made normal to the ray.
inline void start_polarized(const scene::Scene& scene, const CameraStart& start, float weight, Paths& paths,
                            std::size_t i) {
  const math::Vec3d s = scene.camera.polarizer_right({paths.dx[i], paths.dy[i], paths.dz[i]});
  paths.sx[i] = s.x, paths.sy[i] = s.y, paths.sz[i] = s.z;
  paths.state[i].plane = PathState::general_row;
  const float half = 0.5f * weight;
  paths.set_row(i, {Lanes(half), Lanes(half * start.cos_2a), Lanes(half * start.sin_2a), Lanes(0.0f)});
}

inline void tile_seeds(const scene::Scene& scene, const Tile& tile, PixelSeeds* seeds) {
  for (int i = 0; i < tile.pixels(); ++i)
    seeds[i] = pixel_seeds(scene.render.seed, static_cast<std::uint32_t>(tile.x0 + i % tile.width),
                           static_cast<std::uint32_t>(tile.y0 + i / tile.width));
}

struct PicturePoint {
  double x, y;  // in pixels from the top left
};

// Where sample `index` of the pixel (x, y) lies. `second_reversed` is sobol_second_reversed(index).
inline PicturePoint picture_point(const scene::PixelFilter& filter, int x, int y, std::uint32_t index,
                                  std::uint32_t second_reversed, const PixelSeeds& seeds) {
  const float u = pixel_offset_x(index, seeds.x), v = pixel_offset_y(second_reversed, seeds.y);
  const float left = static_cast<float>(x), top = static_cast<float>(y);
  if (filter.is_the_pixel()) return {left + u, top + v};
  return {x + 0.5 + filter.offset_px(u), y + 0.5 + filter.offset_px(v)};
}

// For a camera that is a pinhole. `pixels` lists `count` pixels of the tile; each path carries `weight` of a sample.
inline void camera_rays(const scene::Scene& scene, const CameraStart& start, const Tile& tile, const PixelSeeds* seeds,
                        const std::uint16_t* pixels, int count, std::uint32_t sample, float weight, Paths& paths) {
  paths.reserve(static_cast<std::size_t>(count));
  const std::size_t first = paths.size();
  const std::uint32_t second = sobol_second_reversed(sample);
  const auto comb = static_cast<std::uint16_t>(comb_of_sample(sample));
  alignas(64) double x[tile_pixels + ray_block], y[tile_pixels + ray_block];
  for (int i = 0; i < count; ++i) {
    const int pixel = pixels[i];
    const PicturePoint point = picture_point(scene.filter, tile.x0 + pixel % tile.width, tile.y0 + pixel / tile.width,
                                             sample, second, seeds[pixel]);
    x[i] = point.x, y[i] = point.y;
    PathState& state = paths.state[first + static_cast<std::size_t>(i)];
    state = {};
    state.random = seeds[pixel].x ^ (seeds[pixel].y * 0x9E3779B9u) ^ (sample * 0x85EBCA6Bu);
    state.pixel = pixels[i];
    state.comb = comb;
    state.carried = weight * start.carried;
  }
  for (int i = count; i < count + ray_block; ++i) x[i] = x[0], y[i] = y[0];
  for (int i = 0; i < count; i += ray_block) {
    const math::Vec3<Rays> direction = math::normalize(scene.camera.through(Rays::load(x + i), Rays::load(y + i)));
    const std::size_t at = first + static_cast<std::size_t>(i);
    direction.x.store(&paths.dx[at]), direction.y.store(&paths.dy[at]), direction.z.store(&paths.dz[at]);
    Rays(scene.camera.position.x).store(&paths.ox[at]), Rays(scene.camera.position.y).store(&paths.oy[at]);
    Rays(scene.camera.position.z).store(&paths.oz[at]);
  }
  paths.resize(first + static_cast<std::size_t>(count));
  if (start.polarized)
    for (std::size_t i = first; i < paths.size(); ++i) start_polarized(scene, start, weight, paths, i);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
