#include "bench/geometry/block_search.h"

#include "shabon/render/kernel/next_walls.h"

namespace shabon::bench {

struct BlockSearch::State {
  scene::Scene scene;
  render::SceneTables tables;
  render::Paths paths;
  std::vector<double> distance;
  std::vector<std::int32_t> sphere;
  explicit State(const scene::Scene& of) : scene(of), tables(scene, std::nullopt) {}
};

BlockSearch::BlockSearch(const scene::Scene& scene, const std::vector<geometry::SphereShape>& spheres,
                         const WallRays& rays)
    : state_(std::make_unique<State>(scene)) {
  state_->tables.spheres = geometry::SphereSet(spheres, geometry::WallSearch::one_by_one);
  render::Paths& paths = state_->paths;
  const std::size_t count = rays.from.size();
  paths.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    paths.ox[i] = rays.origin[i].x, paths.oy[i] = rays.origin[i].y, paths.oz[i] = rays.origin[i].z;
    paths.dx[i] = rays.direction[i].x, paths.dy[i] = rays.direction[i].y, paths.dz[i] = rays.direction[i].z;
    paths.state[i].from = rays.from[i];
  }
  paths.resize(count);
  state_->distance.resize(count + render::leaf_block), state_->sphere.resize(count + render::leaf_block);
}

BlockSearch::~BlockSearch() = default;

double BlockSearch::run() {
  render::next_walls(state_->tables, state_->paths, state_->distance.data(), state_->sphere.data());
  double sum = 0;
  for (std::size_t i = 0; i < state_->paths.size(); ++i)
    if (state_->sphere[i] != geometry::no_sphere) sum += state_->distance[i];
  return sum;
}

}  // namespace shabon::bench
