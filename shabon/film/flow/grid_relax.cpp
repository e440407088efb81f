#include "shabon/film/flow/grid_relax.h"

#include <cmath>
#include <numbers>

#include "shabon/film/flow/padded.h"
#include "shabon/film/flow/sweeps.h"

namespace shabon::film {

namespace {

using math::Vec3d;

constexpr int lloyd_iterations = 30;

// Points as three lists, so that sweeps can use wide registers.
struct Points {
  Numbers x, y, z;
  Points(Index count, std::size_t pad)
      : x(static_cast<std::size_t>(count), pad, 1), y(x.size(), pad, 1), z(x.size(), pad, 1) {}
};

struct View {
  const double *x, *y, *z;
  explicit View(const Points& p) : x(p.x.data()), y(p.y.data()), z(p.z.data()) {}
  Vec3d operator[](Index i) const { return {x[i], y[i], z[i]}; }
};

struct Writer {
  double *x, *y, *z;
  explicit Writer(Points& p) : x(p.x.data()), y(p.y.data()), z(p.z.data()) {}
  void put(Index i, const Vec3d& v) const { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

Vec3d circumcentre(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return math::normalize(math::cross(b - a, c - a));
}

void find_corners(const GridTopology& grid, const Points& centres, Points& corners) {
  const View at(centres);
  const Writer to(corners);
  const Index n = grid.owned;
  sweep_owners(grid, [=](const auto& a) {
    to.put(a.c, circumcentre(at[a.c], at[a.template cell<1>()], at[a.template cell<2>()]));
    to.put(n + a.c, circumcentre(at[a.c], at[a.template cell<2>()], at[a.template cell<3>()]));
  });
}

// Centres of mass of the flat triangles between a cell's centre and its corners.
void move_to_centroids(const GridTopology& grid, const Points& centres, const Points& corners, Points& moved) {
  const View at(centres), corner(corners);
  const Writer to(moved);
  sweep_cells(grid, [=](const auto& a) {
    const Vec3d here = at[a.c];
    Vec3d sum{0, 0, 0};
    each_slot([&](auto slot) {
      constexpr int k = slot.value;
      const Vec3d p = corner[a.template tri<k>()] - here, q = corner[a.template tri<(k + 1) % slots>()] - here;
      const Vec3d normal = math::cross(p, q);
      const double twice_area = std::sqrt(math::dot(normal, normal));
      sum = sum + (p + q + 3.0 * here) * twice_area;
    });
    to.put(a.c, math::normalize(sum));
  });
}

// Corners at the icosahedron's vertices, in the order of the cells of level 0, tilted: no vertex is within 30 degrees
// of an axis of coordinates.
std::vector<Vec3d> icosahedron() {
  const double height = 1 / std::sqrt(5.0), radius = 2 / std::sqrt(5.0);
  std::vector<Vec3d> points;
  for (int ring = 0; ring < 2; ++ring)
    for (int p = 0; p < 5; ++p) {
      const double longitude = (72 * p + 36 * ring) * std::numbers::pi / 180;
      points.push_back({radius * std::cos(longitude), radius * std::sin(longitude), ring == 0 ? height : -height});
    }
  points.push_back({0, 0, 1});
  points.push_back({0, 0, -1});
  const Vec3d z = math::normalize(Vec3d{-0.89, 0, -0.55}), x = math::normalize(math::cross(Vec3d{-0.8, 0.4, 1}, z));
  const Vec3d y = math::cross(z, x);
  for (Vec3d& p : points) p = x * p.x + y * p.y + z * p.z;
  return points;
}

// Twice as fine: old centres and the middles between them.
std::vector<Vec3d> halved(const std::vector<Vec3d>& coarse, Index m) {
  const Index fine_m = 2 * m;
  std::vector<Vec3d> fine(static_cast<std::size_t>(10 * fine_m * fine_m + 2));
  const auto at = [&](int panel, Index i, Index j) {
    return coarse[static_cast<std::size_t>(panel_cell(m, panel, i, j))];
  };
  for (int panel = 0; panel < 10; ++panel)
    for (Index j = 0; j < fine_m; ++j)
      for (Index i = 1; i <= fine_m; ++i) {
        const Index low_i = i / 2, high_i = (i + 1) / 2, low_j = j / 2, high_j = (j + 1) / 2;
        const Vec3d sum = at(panel, low_i, high_j) + at(panel, high_i, low_j);  // along slots 0, 1 or 2
        fine[static_cast<std::size_t>(panel_cell(fine_m, panel, i, j))] = math::normalize(sum);
      }
  fine[fine.size() - 2] = coarse[coarse.size() - 2];
  fine[fine.size() - 1] = coarse[coarse.size() - 1];
  return fine;
}

void relax(const GridTopology& grid, std::vector<Vec3d>& centres) {
  Points now(grid.cells, grid.pad()), moved = now, corners(grid.triangles, grid.pad());
  for (std::size_t c = 0; c < centres.size(); ++c) Writer(now).put(static_cast<Index>(c), centres[c]);
  for (int n = 0; n < lloyd_iterations; ++n) {
    find_corners(grid, now, corners);
    move_to_centroids(grid, now, corners, moved);
    std::swap(now, moved);
  }
  for (std::size_t c = 0; c < centres.size(); ++c) centres[c] = View(now)[static_cast<Index>(c)];
}

}  // namespace

std::vector<Vec3d> relaxed_centres(int level) {
  std::vector<Vec3d> centres = icosahedron();
  for (int n = 1; n <= level; ++n) {
    centres = halved(centres, Index{1} << (n - 1));
    relax(make_topology(n), centres);
  }
  return centres;
}

std::vector<Vec3d> circumcentres(const GridTopology& grid, const std::vector<Vec3d>& centres) {
  std::vector<Vec3d> corners(static_cast<std::size_t>(grid.triangles));
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto [a, b, c] = grid.triangle_cells(static_cast<Index>(t));
    corners[t] = circumcentre(centres[static_cast<std::size_t>(a)], centres[static_cast<std::size_t>(b)],
                              centres[static_cast<std::size_t>(c)]);
  }
  return corners;
}

}  // namespace shabon::film
