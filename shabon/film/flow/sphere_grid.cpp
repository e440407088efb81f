#include "shabon/film/flow/sphere_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include "shabon/film/flow/grid_relax.h"

namespace shabon::film {

namespace {

using math::Vec3d;

double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(math::length(math::cross(a, b)), math::dot(a, b)); }

// Signed area of a spherical triangle (Eriksson 1990).
double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double volume = math::dot(a, math::cross(b, c));
  return 2 * std::atan2(volume, 1 + math::dot(a, b) + math::dot(b, c) + math::dot(c, a));
}

void measure_edges(SphereGrid& grid) {
  const GridTopology& topology = grid.topology;
  for (Index c = 0; c < topology.owned; ++c) {
    const CellAround around = topology.around(c);
    for (std::size_t k = 1; k <= owned_slots; ++k) {
      const auto e = static_cast<std::size_t>(around.edge[k]);
      const auto at = [](const std::vector<Vec3d>& list, Index i) -> const Vec3d& {
        return list[static_cast<std::size_t>(i)];
      };
      grid.distance[e] = angle(at(grid.centres, c), at(grid.centres, around.cell[k]));
      grid.length[e] = angle(at(grid.corners, around.tri[k - 1]), at(grid.corners, around.tri[k]));
    }
  }
}

// Areas as sums of the same pieces, so that cells and triangles both sum to the sphere.
void measure_areas(SphereGrid& grid) {
  const GridTopology& topology = grid.topology;
  const auto cells = static_cast<std::size_t>(topology.cells);
  for (std::size_t c = 0; c < cells; ++c) {
    const CellAround around = topology.around(static_cast<Index>(c));
    const Vec3d& here = grid.centres[c];
    std::array<double, slots> kites{};
    const auto middle = [&](std::size_t k) {
      return math::normalize(here + grid.centres[static_cast<std::size_t>(around.cell[k])]);
    };
    for (std::size_t k = 0; k < slots; ++k) {
      const std::size_t next = (k + 1) % slots;
      if (around.sign[k] == 0) continue;
      const std::size_t after = around.sign[next] == 0 ? (next + 1) % slots : next;
      const auto tri = static_cast<std::size_t>(around.tri[k]);
      const Vec3d& corner = grid.corners[tri];
      const double kite = triangle_area(here, middle(k), corner) + triangle_area(here, corner, middle(after));
      kites[k] = kite;
      grid.area[c] += kite;
      grid.triangle_area[tri] += kite;
    }
    for (std::size_t k = 0; k < slots; ++k) grid.kite[k * cells + c] = static_cast<float>(kites[k] / grid.area[c]);
  }
}

}  // namespace

SphereGrid make_sphere_grid(int level) {
  SphereGrid grid;
  grid.topology = make_topology(level);
  grid.centres = relaxed_centres(level);
  grid.corners = circumcentres(grid.topology, grid.centres);
  grid.area = grid.cell_numbers();
  grid.triangle_area = grid.triangle_numbers();
  grid.distance = grid.edge_numbers(1);
  grid.length = grid.edge_numbers(1);
  grid.kite = grid.slot_numbers();
  measure_edges(grid);
  measure_areas(grid);
  return grid;
}

std::shared_ptr<const SphereGrid> sphere_grid(int level) {
  static std::mutex mutex;
  static std::array<std::weak_ptr<const SphereGrid>, 9> kept;
  const std::lock_guard lock(mutex);
  auto& place = kept[static_cast<std::size_t>(std::clamp(level, 0, 8))];
  std::shared_ptr<const SphereGrid> grid = place.lock();
  if (!grid) {
    grid = std::make_shared<const SphereGrid>(make_sphere_grid(level));
    place = grid;
  }
  return grid;
}

}  // namespace shabon::film
