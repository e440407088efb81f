#include "shabon/io/mesh.h"

#include <bit>
#include <cstdint>

namespace shabon::io {

namespace {

void put(std::string& bytes, std::uint32_t value, bool big_end_first) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * (big_end_first ? 3 - i : i) & 0xFF);
}

void put(std::string& bytes, float value, bool big_end_first) {
  put(bytes, std::bit_cast<std::uint32_t>(value), big_end_first);
}

void put(std::string& bytes, const std::array<float, 3>& point, bool big_end_first) {
  for (const float x : point) put(bytes, x, big_end_first);
}

std::string one_line(std::string_view text) {
  std::string line(text.substr(0, 200));  // VTK allows 256 characters
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return line;
}

}  // namespace

std::string ply(const Mesh& mesh, std::string_view comment) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + one_line(comment) + "\nelement vertex " +
                     std::to_string(mesh.points.size()) + "\nproperty float x\nproperty float y\nproperty float z\n";
  for (const MeshNumbers& numbers : mesh.numbers) text += "property float " + std::string(numbers.name) + "\n";
  text += "element face " + std::to_string(mesh.triangles.size()) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    put(text, mesh.points[i], false);
    for (const MeshNumbers& numbers : mesh.numbers) put(text, numbers.values[i], false);
  }
  for (const auto& triangle : mesh.triangles) {
    text += char{3};
    for (const int corner : triangle) put(text, static_cast<std::uint32_t>(corner), false);
  }
  return text;
}

std::string vtk(const Mesh& mesh, std::string_view title) {
  const std::string count = std::to_string(mesh.points.size()), faces = std::to_string(mesh.triangles.size());
  std::string text =
      "# vtk DataFile Version 3.0\n" + one_line(title) + "\nBINARY\nDATASET POLYDATA\nPOINTS " + count + " float\n";
  for (const std::array<float, 3>& point : mesh.points) put(text, point, true);
  text += "\nPOLYGONS " + faces + " " + std::to_string(4 * mesh.triangles.size()) + "\n";
  for (const auto& triangle : mesh.triangles) {
    put(text, std::uint32_t{3}, true);
    for (const int corner : triangle) put(text, static_cast<std::uint32_t>(corner), true);
  }
  text += "\nPOINT_DATA " + count;
  for (const MeshNumbers& numbers : mesh.numbers) {
    text += "\nSCALARS " + std::string(numbers.name) + " float 1\nLOOKUP_TABLE default\n";
    for (const float value : numbers.values) put(text, value, true);
  }
  return text + "\n";
}

}  // namespace shabon::io
