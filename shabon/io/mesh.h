// Triangle meshes with numbers at their corners, for programs that look at simulations.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::io {

struct MeshNumbers {
  std::string_view name;          // letters, digits and '_'
  std::span<const float> values;  // one a corner point
};

struct Mesh {
  std::span<const std::array<float, 3>> points;
  std::span<const std::array<int, 3>> triangles;  // indices of points
  std::vector<MeshNumbers> numbers;
};

// PLY, binary, little end first: the numbers are further properties of the vertices (Blender reads them as attributes).
std::string ply(const Mesh& mesh, std::string_view comment);

// Legacy VTK, binary, big end first, a PolyData with point scalars (ParaView).
std::string vtk(const Mesh& mesh, std::string_view title);

}  // namespace shabon::io
