// The hexagonal icosahedral grid on the unit sphere: 10 4^level + 2 cells, 12 of them pentagons, each the Voronoi cell
// of its centre of mass (a spherical centroidal Voronoi tessellation: Du, Gunzburger, Ju 2003). Edges between cells
// cross the lines between their centres at right angles, half way. No pentagon lies on an axis of coordinates.
#pragma once

#include <memory>
#include <vector>

#include "shabon/film/flow/grid_topology.h"
#include "shabon/film/flow/padded.h"
#include "shabon/math/vec.h"

namespace shabon::film {

struct SphereGrid {
  GridTopology topology;
  std::vector<math::Vec3d> centres;  // of cells
  std::vector<math::Vec3d> corners;  // of triangles: their circumcentres, where three cells meet
  Numbers area;                      // of cells; their sum is 4 pi
  Numbers triangle_area;
  Numbers distance;  // of edges: between the two centres
  Numbers length;    // of edges: between the two corners
  // Six a cell, slot after slot: the share of the cell's area nearest to the corner between the slots k and k + 1. In
  // single precision, as what is summed with them: nothing that is kept depends on it, and memory limits the speed.
  Padded<float> kite;

  Numbers cell_numbers(double value = 0) const { return numbers(topology.cells, value); }
  Numbers edge_numbers(double value = 0) const { return numbers(topology.edges, value); }
  Numbers triangle_numbers(double value = 0) const { return numbers(topology.triangles, value); }
  Padded<float> slot_numbers() const {
    return Padded<float>(static_cast<std::size_t>(topology.cells * slots), topology.pad());
  }

 private:
  Numbers numbers(Index count, double value) const {
    return Numbers(static_cast<std::size_t>(count), topology.pad(), value);
  }
};

// Levels 0 to 8. The same bits on one machine, for any number of threads.
SphereGrid make_sphere_grid(int level);

// The grid of a level, made once for all who hold it at the time.
std::shared_ptr<const SphereGrid> sphere_grid(int level);

}  // namespace shabon::film
