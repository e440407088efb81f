// Loops over the grid. A kernel is called with what stands around a cell and writes only what is that cell's own. It
// runs over all cells with the constant offsets of a panel's inside, which is wrong for cells on a panel's rim and lets
// the compiler use wide registers; then once more for these, by their tables. So a kernel must not read what it writes.
#pragma once

#include <utility>

#include "shabon/film/flow/grid_topology.h"
#include "shabon/film/flow/padded.h"

namespace shabon::film {

// Inside a panel. The signs are known, so is the slot at the other side.
struct InnerAround {
  Index m, n;  // cells along a panel; owned cells
  Index c;

  template <int k>
  Index cell() const {
    return c + (k == 0 ? 1 : k == 1 ? m : k == 2 ? m - 1 : k == 3 ? -1 : k == 4 ? -m : 1 - m);
  }
  template <int k>
  Index edge() const {
    if constexpr (k == 0) return 2 * n + c + 1;
    if constexpr (k == 4) return c - m;
    if constexpr (k == 5) return n + c - m + 1;
    return (k - 1) * n + c;
  }
  template <int k>
  Index tri() const {
    if constexpr (k == 0) return n + c + 1;
    if constexpr (k == 1) return c;
    if constexpr (k == 2) return n + c;
    if constexpr (k == 3) return c - m;
    if constexpr (k == 4) return n + c - m + 1;
    return c - m + 1;
  }
  template <int k>
  static constexpr double sign() {
    return k >= 1 && k <= owned_slots ? 1 : -1;
  }
  // Index of neighbour k's value for the edge between, in an array of six values a cell, slot after slot.
  template <int k>
  Index across(Index cells) const {
    return (k + 3) % slots * cells + cell<k>();
  }
  template <int which>
  Index far_edge() const {
    return which == 0 ? 2 * n + c + m : c - 1;
  }
  template <int which>
  static constexpr double far_sign() {
    return which == 0 ? 1 : -1;
  }
};

// By the cell's table.
struct SeamAround {
  const SeamCell* around;
  Index c;

  explicit SeamAround(const SeamCell& table) : around(&table), c(table.here) {}
  template <int k>
  Index cell() const {
    return around->cell[k];
  }
  template <int k>
  Index edge() const {
    return around->edge[k];
  }
  template <int k>
  Index tri() const {
    return around->tri[k];
  }
  template <int k>
  double sign() const {
    return static_cast<double>(around->sign[k]);
  }
  template <int k>
  Index across(Index) const {
    return around->across[k];
  }
  template <int which>
  Index far_edge() const {
    return around->far_edge[which];
  }
  template <int which>
  double far_sign() const {
    return static_cast<double>(around->far_sign[which]);
  }
};

// A number known to the compiler, as an argument.
template <int k>
struct Slot {
  static constexpr int value = k;
};

// Calls body(Slot<k>{}) for every slot in order.
template <class Body>
[[gnu::always_inline]] inline void each_slot(const Body& body) {
  [&]<int... k>(std::integer_sequence<int, k...>) { (body(Slot<k>{}), ...); }
  (std::make_integer_sequence<int, slots>{});
}

// For the slots 1, 2, 3.
template <class Body>
[[gnu::always_inline]] inline void each_owned_slot(const Body& body) {
  body(Slot<1>{}), body(Slot<2>{}), body(Slot<3>{});
}

// kernel(around) for every cell that owns edges and, with `poles`, for the poles.
template <class Kernel>
inline void sweep(const GridTopology& grid, const Kernel kernel, bool poles) {
  const Index m = grid.m, n = grid.owned;
  SHABON_INDEPENDENT
  for (Index c = 0; c < n; ++c) kernel(InnerAround{m, n, c});
  const std::size_t last = grid.seam_cells.size() - (poles ? 0 : 2);
  for (std::size_t s = 0; s < last; ++s) kernel(SeamAround(grid.seam_cells[s]));
}

// Kernels that write one value a cell.
template <class Kernel>
inline void sweep_cells(const GridTopology& grid, const Kernel& kernel) {
  sweep(grid, kernel, true);
}

// Kernels that write the three edges or two triangles of a cell.
template <class Kernel>
inline void sweep_owners(const GridTopology& grid, const Kernel& kernel) {
  sweep(grid, kernel, false);
}

}  // namespace shabon::film
