#include "shabon/film/sphere_map.h"

#include <algorithm>
#include <array>
#include <string>

namespace shabon::film {

namespace {

// All nodes at the same place as a node on a face's edge: (face, column, row).
struct Node {
  int face, column, row;
};

// Of a direction on the cube: the node of `face` there, if the direction lies on that face.
bool node_on(int face, const math::Vec3d& d, int size, Node& node) {
  const double axis[3] = {d.x, d.y, d.z};
  const double side = face % 2 == 0 ? 1 : -1;
  if (axis[face / 2] != side) return false;
  const double right[] = {d.z, -d.z, d.x, d.x, -d.x, d.x}, down[] = {-d.y, -d.y, -d.z, d.z, -d.y, -d.y};
  const auto place = [&](double at) { return static_cast<int>(std::lround((at + 1) / 2 * (size - 1))); };
  node = {face, place(right[face]), place(down[face])};
  return true;
}

// The nodes on edges and corners get the mean of all that stand at the same place.
void weld(SphereMap& map) {
  const auto mean_at = [&](int face, int column, int row) {
    const math::Vec3d d = node_direction(face, column, row, map.size);
    std::array<std::size_t, 3> places;
    std::size_t count = 0;
    double sum = 0;
    for (int other = 0; other < face_count; ++other) {
      Node node;
      if (!node_on(other, d, map.size, node)) continue;
      places[count] = map.index(node.face, node.column, node.row);
      sum += map.nm[places[count++]];
    }
    for (std::size_t i = 0; i < count; ++i) map.nm[places[i]] = static_cast<float>(sum / static_cast<double>(count));
  };
  const int last = map.size - 1;
  for (int face = 0; face < face_count; ++face)
    for (int i = 0; i <= last; ++i) {
      mean_at(face, i, 0), mean_at(face, i, last);
      mean_at(face, 0, i), mean_at(face, last, i);
    }
}

}  // namespace

math::Vec3d node_direction(int face, int column, int row, int size) {
  // Symmetric about the middle to the last bit: the faces that meet at an edge agree where its nodes are.
  const auto place = [size](int i) { return static_cast<double>(2 * i - (size - 1)) / (size - 1); };
  const double right = place(column), down = place(row);
  switch (face) {
    case 0:
      return {1, -down, right};
    case 1:
      return {-1, -down, -right};
    case 2:
      return {right, 1, -down};
    case 3:
      return {right, -1, down};
    case 4:
      return {-right, -down, 1};
    default:
      return {right, -down, -1};
  }
}

std::vector<math::Vec3d> node_directions(int size) {
  std::vector<math::Vec3d> directions;
  for (int face = 0; face < face_count; ++face)
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        directions.push_back(math::normalize(node_direction(face, column, row, size)));
  return directions;
}

SphereMap sphere_map(int size, const std::function<double(const math::Vec3d&)>& nm_at) {
  SphereMap map{size, {}};
  for (const math::Vec3d& direction : node_directions(size)) map.nm.push_back(static_cast<float>(nm_at(direction)));
  return map;
}

Result<SphereMap> sphere_map(const math::Raster& cube) {
  if (cube.channels != 1 || cube.width < 2 || cube.height != face_count * cube.width)
    return fail(Failure::content,
                "expected a picture six times as high as wide, the faces of a cube below each other, got " +
                    std::to_string(cube.width) + " x " + std::to_string(cube.height));
  SphereMap map{cube.width, cube.values};
  weld(map);
  return map;
}

SphereMap mixed(const SphereMap& a, const SphereMap& b, double share) {
  SphereMap result = a;
  for (std::size_t i = 0; i < result.nm.size(); ++i)
    result.nm[i] = static_cast<float>(a.nm[i] + share * (double(b.nm[i]) - a.nm[i]));
  return result;
}

}  // namespace shabon::film
