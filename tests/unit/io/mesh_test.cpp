#include "shabon/io/mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace shabon::io {
namespace {

const std::array<float, 3> points[] = {{0, 0, 0}, {1, 0, 0}, {0, 1.5f, 0}, {0, 0, -2}};
const std::array<int, 3> triangles[] = {{0, 1, 2}, {0, 3, 1}};
const float nm[] = {100, 200.25f, 300, 400}, speed[] = {0, 1, 2, 3};
const Mesh mesh{points, triangles, {{"thickness_nm", nm}, {"speed_m_s", speed}}};

std::uint32_t word(const std::string& bytes, std::size_t at, bool big_end_first) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto byte = static_cast<unsigned char>(bytes.at(at + i));
    value |= std::uint32_t{byte} << 8 * (big_end_first ? 3 - i : i);
  }
  return value;
}

float number(const std::string& bytes, std::size_t at, bool big_end_first) {
  return std::bit_cast<float>(word(bytes, at, big_end_first));
}

std::size_t after(const std::string& bytes, const std::string& text) {
  const std::size_t at = bytes.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  return at + text.size();
}

TEST(Ply, HoldsPointsNumbersAndTriangles) {
  const std::string bytes = ply(mesh, "a film\nof soap");
  EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\ncomment a film of soap\nelement vertex 4\n"));
  EXPECT_NE(bytes.find("property float speed_m_s\nelement face 2\n"), std::string::npos);
  const std::size_t body = after(bytes, "end_header\n"), vertex = 5 * 4;
  EXPECT_EQ(number(bytes, body + 2 * vertex + 4, false), 1.5f);
  EXPECT_EQ(number(bytes, body + 1 * vertex + 12, false), 200.25f);
  EXPECT_EQ(number(bytes, body + 3 * vertex + 16, false), 3);
  const std::size_t faces = body + 4 * vertex;
  EXPECT_EQ(bytes.at(faces), 3);
  EXPECT_EQ(word(bytes, faces + 13 + 1 + 4, false), 3u);
  EXPECT_EQ(bytes.size(), faces + 2 * 13);
}

TEST(Vtk, HoldsPointsNumbersAndTriangles) {
  const std::string bytes = vtk(mesh, "a film");
  EXPECT_TRUE(bytes.starts_with("# vtk DataFile Version 3.0\na film\nBINARY\nDATASET POLYDATA\n"));
  const std::size_t body = after(bytes, "POINTS 4 float\n");
  EXPECT_EQ(number(bytes, body + 3 * 12 + 8, true), -2);
  const std::size_t faces = after(bytes, "POLYGONS 2 8\n");
  EXPECT_EQ(word(bytes, faces, true), 3u);
  EXPECT_EQ(word(bytes, faces + 16 + 8, true), 3u);
  const std::size_t scalars = after(bytes, "POINT_DATA 4\nSCALARS thickness_nm float 1\nLOOKUP_TABLE default\n");
  EXPECT_EQ(number(bytes, scalars + 4, true), 200.25f);
  EXPECT_EQ(number(bytes, after(bytes, "SCALARS speed_m_s float 1\nLOOKUP_TABLE default\n") + 12, true), 3);
}

}  // namespace
}  // namespace shabon::io
