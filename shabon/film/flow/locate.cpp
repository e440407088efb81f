#include "shabon/film/flow/locate.h"

#include <algorithm>

namespace shabon::film {

using math::Vec3d;

std::size_t nearest_cell(const SphereGrid& grid, const Vec3d& direction, std::size_t from) {
  std::size_t here = from;
  double best = math::dot(grid.centres[here], direction);
  for (;;) {
    const CellAround around = grid.topology.around(static_cast<Index>(here));
    std::size_t next = here;
    for (const Index neighbour : around.cell) {
      const double cosine = math::dot(grid.centres[static_cast<std::size_t>(neighbour)], direction);
      if (cosine > best) best = cosine, next = static_cast<std::size_t>(neighbour);
    }
    if (next == here) return here;
    here = next;
  }
}

// The triangles around the nearest cell hold the direction; of these the one whose least weight is largest, which also
// decides on their common sides.
Place locate(const SphereGrid& grid, const Vec3d& direction, std::size_t from) {
  const std::size_t centre = nearest_cell(grid, direction, from);
  const CellAround around = grid.topology.around(static_cast<Index>(centre));
  const Vec3d& a = grid.centres[centre];
  Place best{};
  double best_least = -1e300;
  for (std::size_t k = 0; k < slots; ++k) {
    if (around.sign[k] == 0) continue;
    const std::size_t next = around.sign[(k + 1) % slots] == 0 ? (k + 2) % slots : (k + 1) % slots;
    const Vec3d& b = grid.centres[static_cast<std::size_t>(around.cell[k])];
    const Vec3d& c = grid.centres[static_cast<std::size_t>(around.cell[next])];
    std::array<double, 3> weight{math::dot(direction, math::cross(b, c)), math::dot(direction, math::cross(c, a)),
                                 math::dot(direction, math::cross(a, b))};
    const double sum = weight[0] + weight[1] + weight[2];
    for (double& w : weight) w /= sum;
    const double least = *std::min_element(weight.begin(), weight.end());
    if (sum > 0 && least > best_least) {
      best_least = least;
      best = {{static_cast<Index>(centre), around.cell[k], around.cell[next]}, weight};
    }
  }
  double sum = 0;
  for (double& w : best.weight) w = std::max(w, 0.0), sum += w;
  for (double& w : best.weight) w /= sum;
  return best;
}

}  // namespace shabon::film
