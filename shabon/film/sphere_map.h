// Thickness over the directions of a sphere, on the six faces of a cube: no pole, no seam, a few steps to look up.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/film/number.h"
#include "shabon/math/raster.h"
#include "shabon/math/vec.h"

namespace shabon::film {

// Nodes on a square grid over each face, from edge to edge: those on an edge or a corner belong to all faces that meet
// there and hold the same number, so that what is interpolated has no seam. Faces are ordered +x -x +y -y +z -z, one
// below the other, and turned as in the cube environment maps of OpenEXR (ImfEnvmap.h): a SphereMap is the data of such
// a picture as it stands.
struct SphereMap {
  int size = 2;                                    // nodes along an edge, >= 2
  std::vector<float> nm = std::vector<float>(24);  // 6 size^2

  std::size_t index(int face, int column, int row) const {
    const auto n = static_cast<std::size_t>(size);
    return (static_cast<std::size_t>(face) * n + static_cast<std::size_t>(row)) * n + static_cast<std::size_t>(column);
  }
};

inline constexpr int face_count = 6;

// Where a node stands, on the cube of half edge 1: not of unit length.
math::Vec3d node_direction(int face, int column, int row, int size);

// Of all nodes in the order of SphereMap::nm, of unit length: what fills a map in one go asks here.
std::vector<math::Vec3d> node_directions(int size);

// The map of `nm_at`, which is asked once for each node, in unit directions. `size` as SphereMap::size.
SphereMap sphere_map(int size, const std::function<double(const math::Vec3d&)>& nm_at);

// From a picture of one channel, six times as high as wide. Nodes of one place get their mean: pictures whose edge
// texels are no nodes have seams otherwise. Refuses another form (Failure::content).
Result<SphereMap> sphere_map(const math::Raster& cube);

// a + share (b - a), node by node. Both have one size.
SphereMap mixed(const SphereMap& a, const SphereMap& b, double share);

// Thickness in nm in the direction `from_centre`, of any length: bilinear between the nodes.
template <class Number>
Number thickness_nm(const SphereMap& map, const math::Vec3<Number>& from_centre) {
  using std::abs, std::max, std::min, std::floor;
  const Number x = from_centre.x, y = from_centre.y, z = from_centre.z;
  const Number ax = abs(x), ay = abs(y), az = abs(z), zero(0.0);
  const auto on_x = (ax >= ay) & (ax >= az);
  const auto on_y = ay >= az;  // where not on x
  // Right and down on the face, times the distance to it, as in node_direction().
  const Number far = max(select(on_x, ax, select(on_y, ay, az)), Number(1e-300));
  const Number right = select(on_x, select(x >= zero, z, -z), select(on_y, x, select(z >= zero, -x, x)));
  const Number down = select(on_x, -y, select(on_y, select(y >= zero, -z, z), -y));
  const Number face =
      select(on_x, select(x >= zero, zero, Number(1.0)),
             select(on_y, select(y >= zero, Number(2.0), Number(3.0)), select(z >= zero, Number(4.0), Number(5.0))));
  const Number cells(map.size - 1.0), half_cells = cells * Number(0.5), last = cells - Number(1.0);
  const Number scale = half_cells / far;
  const Number column = right * scale + half_cells, row = down * scale + half_cells;
  const Number column_0 = max(min(floor(column), last), zero), row_0 = max(min(floor(row), last), zero);
  const Number n(map.size);
  constexpr int lanes = lane_count_of<Number>();
  alignas(64) double first[lanes], nodes[4][lanes];
  to_lanes((face * n + row_0) * n + column_0, first);
  for (int i = 0; i < lanes; ++i) {
    const float* node = map.nm.data() + static_cast<std::ptrdiff_t>(first[i]);
    nodes[0][i] = node[0], nodes[1][i] = node[1];
    nodes[2][i] = node[map.size], nodes[3][i] = node[map.size + 1];
  }
  const Number a = from_lanes<Number>(nodes[0]), c = from_lanes<Number>(nodes[2]);
  const Number to_right = column - column_0, downwards = row - row_0;
  const Number top = a + to_right * (from_lanes<Number>(nodes[1]) - a);
  const Number bottom = c + to_right * (from_lanes<Number>(nodes[3]) - c);
  return top + downwards * (bottom - top);
}

}  // namespace shabon::film
