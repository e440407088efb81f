#include "shabon/render/kernel/scattering/tile.h"

#include "shabon/render/kernel/scattering/sampler.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

constexpr std::uint32_t lens_key = 0x1E4539A7u;  // names the choice of a point of the lens

}  // namespace

WalkStart ScatteringTile::start_of(const Tile& tile, int pixel, const PixelSeeds& seeds, std::uint32_t sample) const {
  const scene::Scene& scene = tables_.scene;
  const PicturePoint at = picture_point(scene.filter, tile.x0 + pixel % tile.width, tile.y0 + pixel / tile.width,
                                        sample, sobol_second_reversed(sample), seeds);
  WalkStart start;
  start.sample = sample;
  start.seed = seeds.x ^ (seeds.y * 0x9E3779B9u);
  scene::LensPoint on_lens;
  if (scene.camera.has_lens()) {
    const SamplePair pair = sample_pair(sample, start.seed ^ lens_key);
    on_lens = scene::lens_point(pair.first, pair.second);
  }
  const scene::CameraRay ray = scene.camera.ray(at.x, at.y, on_lens);
  start.origin = ray.origin, start.direction = ray.direction;
  if (tables_.camera_spaces_differ) start.space = space_at(tables_, start.origin, start.direction);
  start.comb = static_cast<std::size_t>(comb_of_sample(sample));
  start.carried = start_.carried;
  start.row = {unpolarized(Lanes(start_.carried)), {}, false};
  if (start_.polarized) {
    start.row.s = scene.camera.polarizer_right(start.direction);
    start.row.row = {Lanes(0.5f), Lanes(0.5f * start_.cos_2a), Lanes(0.5f * start_.sin_2a), Lanes(0.0f)};
    start.row.polarized = true;
  }
  return start;
}

void ScatteringTile::add(int pixel, const WalkStart& start, const WalkLight& light) {
  std::array<double, 3>& sum = sums_[pixel];
  if (light.direct) {  // the same in every comb, so its colour is known without the lanes
    for (std::size_t k = 0; k < direct_.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += light.direct_carried * direct_[k] * double(tables_.films.channel_xyz[k][c]);
    return;
  }
  const CombTable& comb = tables_.films.combs[start.comb];
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] += math::sum(light.radiance * comb.weight[c] + light.alone * comb.plain_weight[c]);
}

void ScatteringTile::add_samples(const Tile& tile, std::uint32_t first, std::uint32_t end) {
  PixelSeeds seeds[tile_pixels];
  tile_seeds(tables_.scene, tile, seeds);
  for (int pixel = 0; pixel < tile.pixels(); ++pixel)
    for (std::uint32_t sample = first; sample < end; ++sample) {
      const WalkStart start = start_of(tile, pixel, seeds[pixel], sample);
      add(pixel, start, walk_.follow(start, direct_));
    }
  camera_samples_ += static_cast<std::uint64_t>(tile.pixels()) * (end - first);
}

void ScatteringTile::take_sums(const Tile& tile, std::vector<std::array<double, 3>>& xyz) {
  xyz.assign(sums_, sums_ + tile.pixels());
  for (auto& sum : sums_) sum = {};
}

TransportCounts ScatteringTile::counts() const {
  const WalkCounts& walk = walk_.counts();
  return {camera_samples_, walk.rays + walk.shadow_rays, walk.events, walk.cut_paths, walk.dropped};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
