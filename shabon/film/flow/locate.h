// Which cell lies in a direction, and how to interpolate there.
#pragma once

#include <array>

#include "shabon/film/flow/sphere_grid.h"

namespace shabon::film {

// The cell whose centre is nearest, by climbing from neighbour to neighbour; `from` any cell, best one nearby.
std::size_t nearest_cell(const SphereGrid& grid, const math::Vec3d& direction, std::size_t from);

// The triangle between the centres of three cells that holds a direction (of any length but zero), and the weights of
// the three: not negative, their sum is 1.
struct Place {
  std::array<Index, 3> cell;
  std::array<double, 3> weight;
};
Place locate(const SphereGrid& grid, const math::Vec3d& direction, std::size_t from);

}  // namespace shabon::film
