// The grid with its lengths in metres, and the operators that need no physics, (70)-(74) in docs/living-film.md.
#pragma once

#include <memory>

#include "shabon/film/flow/sphere_grid.h"

namespace shabon::film {

struct Metric {
  std::shared_ptr<const SphereGrid> grid;
  double radius = 1;
  Numbers area, per_area;          // of cells
  Numbers per_triangle_area;       // of triangles
  Numbers length, per_length;      // of edges, between corners
  Numbers distance, per_distance;  // of edges, between centres
  double least_distance = 0;

  Metric(std::shared_ptr<const SphereGrid> unit_sphere, double radius_m);
  const GridTopology& topology() const { return grid->topology; }
};

// Sums over blocks of fixed size: the same bits whatever registers the compiler uses. `a` and `b` have `count` numbers.
double dot(const double* a, const double* b, Index count);

double sum(const double* a, Index count);

// Sum of value times area over the sphere.
double integral(const Metric& metric, const Numbers& cells);

// Out of each cell per area, (70), from velocities along the edges.
void divergence(const Metric& metric, const Numbers& along, Numbers& cells);
// Along the edges, (71), from values of cells.
void gradient(const Metric& metric, const Numbers& cells, Numbers& along);
// Circulation per area of triangles, (72).
void curl(const Metric& metric, const Numbers& along, Numbers& triangles);
// Velocities along the edges of a stream function at the corners, (73): their divergence is zero to rounding.
void from_stream(const Metric& metric, const Numbers& triangles, Numbers& along);

// Kinetic energy of cells, and what (74) sums of each cell for the velocity across its edges, six numbers a cell.
void cell_terms(const Metric& metric, const Numbers& along, Numbers& kinetic, Padded<float>& turned);
// Velocities across the edges (to their left), (74).
void across(const Metric& metric, const Padded<float>& turned, Numbers& left);

// Velocity vectors at the cells that fit the edges' components best.
std::vector<math::Vec3d> cell_vectors(const Metric& metric, const Numbers& along);
// The components along the edges of a field of vectors, given at the edges' middles.
template <class Field>
void along_edges(const SphereGrid& grid, const Field& field, Numbers& along) {
  for (Index c = 0; c < grid.topology.owned; ++c) {
    const CellAround around = grid.topology.around(c);
    for (std::size_t k = 1; k <= owned_slots; ++k) {
      const math::Vec3d a = grid.centres[static_cast<std::size_t>(c)];
      const math::Vec3d b = grid.centres[static_cast<std::size_t>(around.cell[k])];
      along[static_cast<std::size_t>(around.edge[k])] =
          math::dot(field(math::normalize(a + b)), math::normalize(b - a));
    }
  }
}

}  // namespace shabon::film
