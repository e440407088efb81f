// Where the cells of the icosahedral grid lie: halved edges of the icosahedron, moved to the centres of their Voronoi
// cells (Lloyd's iteration) after each halving.
#pragma once

#include <vector>

#include "shabon/film/flow/grid_topology.h"
#include "shabon/math/vec.h"

namespace shabon::film {

std::vector<math::Vec3d> relaxed_centres(int level);

// Unit vectors to where the Voronoi cells of three centres meet.
std::vector<math::Vec3d> circumcentres(const GridTopology& grid, const std::vector<math::Vec3d>& centres);

}  // namespace shabon::film
