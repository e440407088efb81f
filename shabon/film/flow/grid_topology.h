// Who neighbours whom on the icosahedral grid, in panels so that neighbours lie at constant offsets.
//
// The icosahedron's 20 faces are paired to 10 rhombic panels of M x M cells, M = 2^level; panel p holds the cells
// (i, j), 1 <= i <= M, 0 <= j < M, in the order 10 rows of panels, j, i. The two poles come last. Around a cell, its
// six slots run counterclockwise from (i + 1, j):
//
//         2   1          0: (i+1, j)   1: (i, j+1)   2: (i-1, j+1)
//       3   c   0        3: (i-1, j)   4: (i, j-1)   5: (i+1, j-1)
//         4   5
//
// A cell that is no pole owns the edges to its slots 1, 2, 3 and the two triangles between them; edges point away from
// their owner. Pentagons leave slot 0 empty. All of it lies in the square of cells behind the panel's cell, so panels
// fit together without exceptions; only the numbers of cells on a panel's rim differ from the constant offsets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shabon::film {

using Index = std::ptrdiff_t;

inline constexpr int slots = 6;
inline constexpr int owned_slots = 3;

// What stands around one cell; sign +1 for edges that point away, -1 for those that point to it, 0 in an empty slot.
// `tri[k]` lies between the slots k and k + 1. `opposite[k]` is the slot that this cell has around its neighbour.
struct CellAround {
  std::array<Index, slots> cell, edge, tri;
  std::array<double, slots> sign;
  std::array<int, slots> opposite;
  // Of the owned triangles 0 (slots 1, 2) and 1 (slots 2, 3): the edge across from the cell, counterclockwise.
  std::array<Index, 2> far_edge;
  std::array<double, 2> far_sign;
};

// The same for sweeps, in little room. `across[k]` is opposite[k] times the number of cells, plus cell[k].
struct SeamCell {
  std::int32_t here;
  std::array<std::int32_t, slots> cell, edge, tri, across;
  std::array<std::int32_t, 2> far_edge;
  std::array<float, slots> sign;
  std::array<float, 2> far_sign;
};

struct GridTopology {
  int level = 0;
  Index m = 1;       // cells along a panel
  Index owned = 10;  // cells that own edges and triangles; the two poles follow
  Index cells = 12;
  Index edges = 30;
  Index triangles = 20;
  std::vector<Index> seam;  // cells whose numbers follow no constant offsets, the poles last
  std::vector<CellAround> seam_around;
  std::vector<SeamCell> seam_cells;

  // The number of the owned edge to a slot 1, 2, 3 and of the owned triangles 0, 1.
  Index edge_of(Index cell, int slot) const { return (slot - 1) * owned + cell; }
  Index triangle_of(Index cell, int which) const { return which * owned + cell; }
  std::size_t pad() const { return static_cast<std::size_t>(m + 2); }

  CellAround around(Index cell) const;  // of any cell
  std::array<Index, 3> triangle_cells(Index triangle) const;

  std::vector<int> seam_place;  // of each cell: its place in `seam`, or -1
};

GridTopology make_topology(int level);

// The cell at (i, j), 0 <= i, j <= m, of the closed panel: of another panel where i = 0 or j = m.
Index panel_cell(Index m, int panel, Index i, Index j);

}  // namespace shabon::film
