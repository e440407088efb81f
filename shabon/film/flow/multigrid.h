// An approximate inverse of the elastic step's matrix, area + L, by one V-cycle over the nested icosahedral grids: the
// preconditioner of elastic_solver.h. Single precision: it need not be exact, only symmetric.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shabon/film/flow/metric.h"

namespace shabon::film {

class Multigrid {
 public:
  explicit Multigrid(const Metric& metric);

  // For another matrix: the couplings of the finest level's edges.
  void set(const Numbers& coupling);
  // The inverse's image of `residual`.
  void apply(const Numbers& residual, Numbers& image);

 private:
  using Floats = Padded<float>;
  struct Level {
    GridTopology topology;
    Floats mass, coupling;
    Floats damping;             // of Jacobi's iteration: share over the diagonal
    Floats right, value, next;  // what is sought is `value`
    // On the next finer level: the cell at the same place and its neighbours; the two halves of each owned edge.
    std::vector<std::array<std::int32_t, slots + 1>> finer_cells;
    std::vector<std::array<std::int32_t, 2>> finer_edges;
    // On the next coarser level, for the cells of the seam: the two cells this one lies between.
    std::vector<std::array<std::int32_t, 2>> seam_parents;
  };
  static void link(Level& fine, Level& coarse);
  static void weigh(Level& level);
  static void restrict_residual(Level& fine, Level& coarse);
  static void add_correction(Level& fine, const Level& coarse);
  static void smooth_from_zero(Level& level);
  static void smooth(Level& level);
  void cycle(std::size_t depth);

  std::vector<Level> levels_;  // the finest first
};

}  // namespace shabon::film
