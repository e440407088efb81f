// Shapes that lie on one another: which of them a ray meets first is then a matter of rounding, or of their order.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "shabon/geometry/shape.h"

namespace shabon::geometry {

// Two surfaces this near to each other, in units of the size of the smaller, are one. What overlaps by less is taken to
// touch at the edge only.
inline constexpr double coincidence_tolerance = 1e-9;

// The pairs (i, j), i < j in rising order, of shapes that have a piece of surface in common: flat ones in one plane,
// spheres or tubes of one centre or axis and one size. Ellipses are compared along 720 directions: those that overlap
// by less than 1e-5 of their size may go unnoticed, or be named although they only come that near. Shapes that merely
// cross do not count.
std::vector<std::pair<int, int>> coincident(std::span<const PlacedShape> shapes);

}  // namespace shabon::geometry
