#include "shabon/io/primaries.h"

#include <cmath>
#include <cstddef>

namespace shabon::io {

namespace {

double determinant(const Matrix3& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Written so that NaN gives nothing.
std::optional<Matrix3> inverse(const Matrix3& m) {
  constexpr double smallest_determinant = 1e-9;
  const double d = determinant(m);
  if (!(std::abs(d) > smallest_determinant) || !std::isfinite(d)) return {};
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r1 = (j + 1) % 3, r2 = (j + 2) % 3, c1 = (i + 1) % 3, c2 = (i + 2) % 3;
      result[i][j] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / d;
    }
  return result;
}

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

std::array<double, 3> xyz_of(Chromaticity c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

}  // namespace

std::optional<Matrix3> rgb_to_xyz(const RgbPrimaries& primaries) {
  // The unscaled columns are (x, y, z): finite for any primary, also one with y = 0.
  const std::array<Chromaticity, 3> colors{primaries.red, primaries.green, primaries.blue};
  Matrix3 columns;
  for (std::size_t j = 0; j < 3; ++j) {
    columns[0][j] = colors[j].x;
    columns[1][j] = colors[j].y;
    columns[2][j] = 1 - colors[j].x - colors[j].y;
  }
  const auto inverted = inverse(columns);
  if (!inverted || !(primaries.white.y > 0)) return {};
  const std::array<double, 3> white = xyz_of(primaries.white);
  for (std::size_t j = 0; j < 3; ++j) {
    double scale = 0;
    for (std::size_t k = 0; k < 3; ++k) scale += (*inverted)[j][k] * white[k];
    if (!std::isfinite(scale)) return {};
    for (std::size_t i = 0; i < 3; ++i) columns[i][j] *= scale;
  }
  return columns;
}

std::optional<Matrix3> rgb_to_srgb(const RgbPrimaries& primaries) {
  const auto to_xyz = rgb_to_xyz(primaries);
  if (!to_xyz) return {};
  return product(*inverse(*rgb_to_xyz(srgb_primaries)), *to_xyz);
}

bool is_identity(const Matrix3& matrix) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(std::abs(matrix[i][j] - (i == j ? 1 : 0)) <= 1e-5)) return false;
  return true;
}

}  // namespace shabon::io
