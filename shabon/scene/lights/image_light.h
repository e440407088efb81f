// A latitude-longitude picture at infinity, equation (25): linear sRGB, bilinear between texel centres, wrapping in u,
// clamped in v.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "shabon/math/vec.h"

namespace shabon::scene {

// Texels as r, g, b, 0 in one 16-byte group, the first column repeated after the last: a bilinear look-up reads four
// groups and never wraps.
struct EnvironmentPicture {
  int width = 0, height = 0;
  std::vector<float> texels;  // (width + 1) * height * 4

  const float* texel(int column, int row) const {
    return texels.data() +
           4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width + 1) + static_cast<std::size_t>(column));
  }
};

struct ImageLight {
  std::shared_ptr<const EnvironmentPicture> picture;
  int first_channel = 0;  // channels first, first + 1, first + 2: the red, green and blue basis times the lamp
  double rotation_turns = 0;
  double scale = 1;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    using std::acos, std::atan2, std::floor;
    const T azimuth_turns = atan2(direction.x, -direction.z) * T(0.5 * std::numbers::inv_pi);
    T u = T(0.5 - rotation_turns) + azimuth_turns;
    u = u - floor(u);
    const T v = acos(direction.y) * T(std::numbers::inv_pi);
    T rgb[3];
    bilinear(*picture, u, v, rgb);
    for (int c = 0; c < 3; ++c) coefficients[first_channel + c] = coefficients[first_channel + c] + rgb[c] * T(scale);
  }
};

// The four texels around the point (u, v) of the unit square and their weights, for one point.
struct BilinearFootprint {
  int column, top, bottom;  // the right neighbour of `column` is column + 1, the repeated one at the seam
  double fx, fy;
};

inline BilinearFootprint bilinear_footprint(const EnvironmentPicture& picture, double u, double v) {
  double x = u * picture.width - 0.5, y = v * picture.height - 0.5;
  if (x < 0) x += picture.width;
  int column = static_cast<int>(x), row = static_cast<int>(std::floor(y));
  if (column >= picture.width) column = picture.width - 1;  // u rounded up to 1
  const int last = picture.height - 1;
  return {column, row < 0 ? 0 : row > last ? last : row, row + 1 > last ? last : row + 1, x - column, y - row};
}

inline void bilinear(const EnvironmentPicture& picture, double u, double v, double* rgb) {
  const BilinearFootprint at = bilinear_footprint(picture, u, v);
  const float* top = picture.texel(at.column, at.top);
  const float* bottom = picture.texel(at.column, at.bottom);
  for (int c = 0; c < 3; ++c) {
    const double above = top[c] + at.fx * (double(top[4 + c]) - top[c]);
    const double below = bottom[c] + at.fx * (double(bottom[4 + c]) - bottom[c]);
    rgb[c] = above + at.fy * (below - above);
  }
}

}  // namespace shabon::scene
