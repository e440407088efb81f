#include "shabon/film/flow/grid_topology.h"

namespace shabon::film {

// Northern panels p = 0..4 have their corners (0, 0), (m, 0), (0, m), (m, m) at the north pole, at A_p, A_p+1 of the
// upper ring and at B_p of the lower ring; southern panels 5 + p at A_p+1, B_p, B_p+1 and the south pole.
Index panel_cell(Index m, int panel, Index i, Index j) {
  const Index owned = 10 * m * m;
  const bool north = panel < 5;
  const int next = north ? (panel + 1) % 5 : 5 + (panel - 5 + 1) % 5;
  if (i > 0 && j < m) return (panel * m + j) * m + i - 1;
  if (north) {
    if (i == 0) return j == 0 ? owned : panel_cell(m, next, j, 0);
    return panel_cell(m, panel + 5, i, 0);
  }
  if (i == 0 && j < m) return panel_cell(m, next - 5, m, j);
  return i == m ? owned + 1 : panel_cell(m, next, m, i);
}

namespace {

// One corner of a triangle: from the cell's neighbour to the next one counterclockwise.
struct Corner {
  Index from, to, tri;
};

struct Spoke {
  Index neighbour, edge;
  double sign;
};

struct Lists {
  std::vector<std::vector<Corner>> corners;
  std::vector<std::vector<Spoke>> spokes;
};

Lists lists_of(const GridTopology& grid) {
  Lists lists{std::vector<std::vector<Corner>>(static_cast<std::size_t>(grid.cells)),
              std::vector<std::vector<Spoke>>(static_cast<std::size_t>(grid.cells))};
  const auto at = [](auto& list, Index cell) -> auto& { return list[static_cast<std::size_t>(cell)]; };
  for (Index c = 0; c < grid.owned; ++c) {
    const auto panel = static_cast<int>(c / (grid.m * grid.m));
    const Index j = c / grid.m % grid.m, i = c % grid.m + 1;
    const Index around[] = {panel_cell(grid.m, panel, i, j + 1), panel_cell(grid.m, panel, i - 1, j + 1),
                            panel_cell(grid.m, panel, i - 1, j)};
    for (int slot = 1; slot <= owned_slots; ++slot) {
      at(lists.spokes, c).push_back({around[slot - 1], grid.edge_of(c, slot), 1});
      at(lists.spokes, around[slot - 1]).push_back({c, grid.edge_of(c, slot), -1});
    }
    for (int which = 0; which < 2; ++which) {
      const Index a = around[which], b = around[which + 1], tri = grid.triangle_of(c, which);
      at(lists.corners, c).push_back({a, b, tri});
      at(lists.corners, a).push_back({b, c, tri});
      at(lists.corners, b).push_back({c, a, tri});
    }
  }
  return lists;
}

const Spoke& spoke_to(const std::vector<Spoke>& spokes, Index neighbour) {
  std::size_t k = 0;
  while (k + 1 < spokes.size() && spokes[k].neighbour != neighbour) ++k;
  return spokes[k];
}

CellAround ordered(const GridTopology& grid, const Lists& lists, Index c) {
  const auto& corners = lists.corners[static_cast<std::size_t>(c)];
  const auto& spokes = lists.spokes[static_cast<std::size_t>(c)];
  CellAround around{};
  around.cell.fill(c), around.edge.fill(c < grid.owned ? c : 0), around.tri.fill(0), around.sign.fill(0);
  Index neighbour = spokes.front().neighbour;  // in slot 1: of poles any, else along the first owned edge
  for (const Spoke& spoke : spokes)
    if (spoke.sign > 0 && spoke.edge == grid.edge_of(c, 1)) neighbour = spoke.neighbour;
  for (std::size_t n = 0; n < spokes.size(); ++n) {
    const std::size_t k = (n + 1) % slots;
    const Spoke& spoke = spoke_to(spokes, neighbour);
    around.cell[k] = neighbour, around.edge[k] = spoke.edge, around.sign[k] = spoke.sign;
    for (const Corner& corner : corners) {
      if (corner.from != neighbour) continue;
      around.tri[k] = corner.tri;
      neighbour = corner.to;
      break;
    }
  }
  if (spokes.size() < slots) around.tri[0] = around.tri[slots - 1];
  for (int which = 0; which < 2 && c < grid.owned; ++which) {
    const Index a = around.cell[static_cast<std::size_t>(which + 1)],
                b = around.cell[static_cast<std::size_t>(which + 2)];
    const Spoke& far = spoke_to(lists.spokes[static_cast<std::size_t>(a)], b);
    around.far_edge[static_cast<std::size_t>(which)] = far.edge;
    around.far_sign[static_cast<std::size_t>(which)] = far.sign;
  }
  return around;
}

// Inside a panel.
CellAround by_offsets(const GridTopology& grid, Index c) {
  const Index m = grid.m, n = grid.owned;
  return {.cell = {c + 1, c + m, c + m - 1, c - 1, c - m, c - m + 1},
          .edge = {2 * n + c + 1, c, n + c, 2 * n + c, c - m, n + c - m + 1},
          .tri = {n + c + 1, c, n + c, c - m, n + c - m + 1, c - m + 1},
          .sign = {-1, 1, 1, 1, -1, -1},
          .opposite = {3, 4, 5, 0, 1, 2},
          .far_edge = {2 * n + c + m, c - 1},
          .far_sign = {1, -1}};
}

SeamCell compact(const GridTopology& grid, Index c, const CellAround& around) {
  SeamCell small{};
  small.here = static_cast<std::int32_t>(c);
  for (std::size_t k = 0; k < slots; ++k) {
    small.cell[k] = static_cast<std::int32_t>(around.cell[k]);
    small.edge[k] = static_cast<std::int32_t>(around.edge[k]);
    small.tri[k] = static_cast<std::int32_t>(around.tri[k]);
    small.across[k] = static_cast<std::int32_t>(around.opposite[k] * grid.cells + around.cell[k]);
    small.sign[k] = static_cast<float>(around.sign[k]);
  }
  for (std::size_t n = 0; n < 2; ++n) {
    small.far_edge[n] = static_cast<std::int32_t>(around.far_edge[n]);
    small.far_sign[n] = static_cast<float>(around.far_sign[n]);
  }
  return small;
}

bool inside(const GridTopology& grid, Index c) {
  if (c >= grid.owned) return false;
  const Index i = c % grid.m + 1, j = c / grid.m % grid.m;
  return i > 1 && i < grid.m && j > 0 && j < grid.m - 1;
}

}  // namespace

CellAround GridTopology::around(Index cell) const {
  const int place = seam_place[static_cast<std::size_t>(cell)];
  return place < 0 ? by_offsets(*this, cell) : seam_around[static_cast<std::size_t>(place)];
}

std::array<Index, 3> GridTopology::triangle_cells(Index triangle) const {
  const Index c = triangle % owned;
  const auto which = static_cast<std::size_t>(triangle / owned);
  const CellAround a = around(c);
  return {c, a.cell[which + 1], a.cell[which + 2]};
}

GridTopology make_topology(int level) {
  GridTopology grid;
  grid.level = level;
  grid.m = Index{1} << level;
  grid.owned = 10 * grid.m * grid.m;
  grid.cells = grid.owned + 2;
  grid.edges = 3 * grid.owned;
  grid.triangles = 2 * grid.owned;
  const Lists lists = lists_of(grid);
  grid.seam_place.assign(static_cast<std::size_t>(grid.cells), -1);
  for (Index c = 0; c < grid.cells; ++c) {
    if (inside(grid, c)) continue;
    grid.seam_place[static_cast<std::size_t>(c)] = static_cast<int>(grid.seam.size());
    grid.seam.push_back(c);
    grid.seam_around.push_back(ordered(grid, lists, c));
  }
  for (std::size_t n = 0; n < grid.seam.size(); ++n) {
    CellAround& here = grid.seam_around[n];
    for (std::size_t k = 0; k < slots; ++k) {
      here.opposite[k] = static_cast<int>(k);
      if (here.sign[k] == 0) continue;
      const CellAround there = grid.around(here.cell[k]);
      for (std::size_t other = 0; other < slots; ++other)
        if (there.sign[other] != 0 && there.cell[other] == grid.seam[n] && there.edge[other] == here.edge[k])
          here.opposite[k] = static_cast<int>(other);
    }
    grid.seam_cells.push_back(compact(grid, grid.seam[n], here));
  }
  return grid;
}

}  // namespace shabon::film
