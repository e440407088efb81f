// The icosahedral grid: counts, neighbours, areas, shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "shabon/film/flow/sphere_grid.h"
#include "shabon/film/flow/sweeps.h"

namespace shabon::film {
namespace {

using math::Vec3d;

class Grid : public testing::TestWithParam<int> {
 protected:
  std::shared_ptr<const SphereGrid> grid_ = sphere_grid(GetParam());
  const GridTopology& topology_ = grid_->topology;
};

TEST_P(Grid, HasAsManyCellsEdgesTrianglesAsASphere) {
  const Index four = Index{1} << (2 * GetParam());
  EXPECT_EQ(topology_.cells, 10 * four + 2);
  EXPECT_EQ(topology_.edges, 30 * four);
  EXPECT_EQ(topology_.triangles, 20 * four);
  int pentagons = 0;
  for (Index c = 0; c < topology_.cells; ++c) pentagons += topology_.around(c).sign[0] == 0;
  EXPECT_EQ(pentagons, 12);
}

TEST_P(Grid, NeighboursAgreeWhoTheyAre) {
  std::vector<int> uses(static_cast<std::size_t>(topology_.edges)),
      corners(static_cast<std::size_t>(topology_.triangles));
  for (Index c = 0; c < topology_.cells; ++c) {
    const CellAround here = topology_.around(c);
    std::set<Index> tris;
    for (std::size_t k = 0; k < slots; ++k) {
      tris.insert(here.tri[k]);
      if (here.sign[k] == 0) continue;
      ++uses[static_cast<std::size_t>(here.edge[k])];
      const CellAround there = topology_.around(here.cell[k]);
      const auto back = static_cast<std::size_t>(here.opposite[k]);
      EXPECT_EQ(there.cell[back], c);
      EXPECT_EQ(there.edge[back], here.edge[k]);
      EXPECT_EQ(there.sign[back], -here.sign[k]);
    }
    for (const Index tri : tris) ++corners[static_cast<std::size_t>(tri)];
  }
  EXPECT_EQ(std::set<int>(uses.begin(), uses.end()), std::set<int>{2});
  EXPECT_EQ(std::set<int>(corners.begin(), corners.end()), std::set<int>{3});
}

// What a sweep sees around a cell.
template <class Around>
void expect_same(const Around& seen, const CellAround& table, Index cells) {
  each_slot([&](auto slot) {
    constexpr int k = slot.value;
    EXPECT_EQ(seen.template cell<k>(), table.cell[k]);
    EXPECT_EQ(seen.template edge<k>(), table.edge[k]);
    EXPECT_EQ(seen.template tri<k>(), table.tri[k]);
    EXPECT_EQ(seen.template sign<k>(), table.sign[k]);
    EXPECT_EQ(seen.template across<k>(cells), table.opposite[k] * cells + table.cell[k]);
  });
  EXPECT_EQ(seen.template far_edge<0>(), table.far_edge[0]);
  EXPECT_EQ(seen.template far_edge<1>(), table.far_edge[1]);
  EXPECT_EQ(seen.template far_sign<0>(), table.far_sign[0]);
  EXPECT_EQ(seen.template far_sign<1>(), table.far_sign[1]);
}

// What the compiler knows of a panel's inside is what the tables say.
TEST_P(Grid, ConstantOffsetsAreTheTables) {
  std::size_t inside = 0;
  for (Index c = 0; c < topology_.owned; ++c) {
    if (topology_.seam_place[static_cast<std::size_t>(c)] >= 0) continue;
    ++inside;
    const CellAround table = topology_.around(c);
    const InnerAround inner{topology_.m, topology_.owned, c};
    expect_same(inner, table, topology_.cells);
  }
  for (std::size_t n = 0; n < topology_.seam.size(); ++n)
    expect_same(SeamAround(topology_.seam_cells[n]), topology_.seam_around[n], topology_.cells);
  EXPECT_EQ(inside + topology_.seam.size(), static_cast<std::size_t>(topology_.cells));
}

TEST_P(Grid, AreasSumToTheSphere) {
  double cells = 0, triangles = 0;
  for (const double area : grid_->area.values()) cells += area;
  for (const double area : grid_->triangle_area.values()) triangles += area;
  EXPECT_NEAR(cells / (4 * std::numbers::pi), 1, 1e-12);
  EXPECT_NEAR(triangles / (4 * std::numbers::pi), 1, 1e-12);
  const auto kites = grid_->kite.values();
  const auto cell_count = static_cast<std::size_t>(topology_.cells);
  for (std::size_t c = 0; c < cell_count; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < slots; ++k) sum += static_cast<double>(kites[k * cell_count + c]);
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST_P(Grid, CellsAreAlike) {
  const auto ratio = [](std::span<const double> values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high / *low;
  };
  EXPECT_LT(ratio(grid_->distance.values()), 1.36);
  EXPECT_LT(ratio(grid_->area.values()), 1.65);
}

TEST_P(Grid, TrianglesTurnCounterclockwise) {
  for (Index t = 0; t < topology_.triangles; ++t) {
    const auto cells = topology_.triangle_cells(t);
    const auto at = [&](std::size_t i) { return grid_->centres[static_cast<std::size_t>(cells[i])]; };
    EXPECT_GT(math::dot(at(0), math::cross(at(1), at(2))), 0);
  }
}

TEST_P(Grid, NoPentagonIsOnAnAxis) {
  for (Index c = 0; c < topology_.cells; ++c) {
    if (topology_.around(c).sign[0] != 0) continue;
    const Vec3d p = grid_->centres[static_cast<std::size_t>(c)];
    EXPECT_LT(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), std::cos(0.5));
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, Grid, testing::Values(0, 1, 2, 3, 5));

}  // namespace
}  // namespace shabon::film
