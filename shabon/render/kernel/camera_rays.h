// The first generation: one path per pixel of a tile for one sample number, all on the same wavelength comb.
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

// The camera's view of unpolarised light: 1, or half behind an ideal polariser, whose row points along its axis.
inline void start_rows(const scene::Scene& scene, Paths& paths, std::size_t first, std::size_t end) {
  const scene::Camera& camera = scene.camera;
  const bool paper = scene.render.interference == optics::Interference::two_beam;
  const float half = camera.polarizer_rad ? 0.25f : 0.5f;
  for (std::size_t i = first; i < end; ++i) {
    paths.state[i].carried = 2 * half;
    paths.row[i].q0 = Lanes(half), paths.row[i].q1 = Lanes(half);
    if (!camera.polarizer_rad || paper) continue;
    const math::Vec3d d{paths.dx[i], paths.dy[i], paths.dz[i]};
    const math::Vec3d s = math::normalize(camera.right - d * math::dot(camera.right, d));
    paths.sx[i] = s.x, paths.sy[i] = s.y, paths.sz[i] = s.z;
    paths.state[i].plane = PathState::general_row;
    const double turn = 2 * *camera.polarizer_rad;
    paths.row[i] = {Lanes(0.5f), Lanes(static_cast<float>(0.5 * std::cos(turn))),
                    Lanes(static_cast<float>(0.5 * std::sin(turn))), Lanes(0.0f)};
  }
}

inline void camera_rays(const scene::Scene& scene, const Tile& tile, std::uint32_t sample, Paths& paths) {
  const int count = tile.pixels();
  paths.reserve(static_cast<std::size_t>(count));
  const std::size_t first = paths.size();
  const std::uint32_t second = sobol_second_reversed(sample);
  const auto comb = static_cast<std::uint16_t>(comb_of_sample(sample));
  alignas(64) double x[tile_pixels + ray_block], y[tile_pixels + ray_block];
  for (int i = 0; i < count; ++i) {
    const int px = tile.x0 + i % tile.width, py = tile.y0 + i / tile.width;
    const PixelSeeds seeds =
        pixel_seeds(scene.render.seed, static_cast<std::uint32_t>(px), static_cast<std::uint32_t>(py));
    x[i] = px + pixel_offset_x(sample, seeds.x);
    y[i] = py + pixel_offset_y(second, seeds.y);
    PathState& state = paths.state[first + static_cast<std::size_t>(i)];
    state = {};
    state.random = seeds.x ^ (seeds.y * 0x9E3779B9u) ^ (sample * 0x85EBCA6Bu);
    state.pixel = static_cast<std::uint16_t>(i);
    state.comb = comb;
  }
  for (int i = count; i < count + ray_block; ++i) x[i] = x[0], y[i] = y[0];
  for (int i = 0; i < count; i += ray_block) {
    const math::Vec3<Rays> through = scene.camera.through(Rays::load(x + i), Rays::load(y + i));
    const math::Vec3<Rays> direction = math::normalize(through);
    const std::size_t at = first + static_cast<std::size_t>(i);
    direction.x.store(&paths.dx[at]), direction.y.store(&paths.dy[at]), direction.z.store(&paths.dz[at]);
    Rays(scene.camera.position.x).store(&paths.ox[at]), Rays(scene.camera.position.y).store(&paths.oy[at]);
    Rays(scene.camera.position.z).store(&paths.oz[at]);
  }
  paths.resize(first + static_cast<std::size_t>(count));
  start_rows(scene, paths, first, paths.size());
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
