// The renderer's search for the next wall, over blocks of rays. The source is compiled for each kind of machine.
#pragma once

#include <memory>
#include <vector>

#include "shabon/geometry/sphere_set.h"
#include "shabon/scene/scene.h"

namespace shabon::bench {

struct WallRays {
  std::vector<math::Vec3d> origin, direction;
  std::vector<int> from;
};

class BlockSearch {
 public:
  // `scene` gives the film, `spheres` the walls, looked at one by one.
  BlockSearch(const scene::Scene& scene, const std::vector<geometry::SphereShape>& spheres, const WallRays& rays);
  ~BlockSearch();

  // The sum of the distances to the next walls.
  double run();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shabon::bench
