// A picture of numbers over the unit square, read between its texel centres.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace shabon::math {

struct Raster {
  int width = 0, height = 0, channels = 1;
  std::vector<float> values;  // rows from top to bottom, the channels of a texel side by side

  const float* texel(int column, int row) const {
    return values.data() +
           static_cast<std::size_t>(channels) *
               (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
  }
};

// What lies beyond the edge: the opposite edge again, or the last texel.
enum class RasterEdge { repeat, clamp };

namespace detail {

struct RasterPair {
  int first, second;
  float share;  // of the second
};

inline RasterPair raster_pair(double at, int size, RasterEdge edge) {
  if (edge == RasterEdge::repeat) at -= std::floor(at);
  double x = at * size - 0.5;
  const double whole = std::floor(x);
  const auto inside = [&](double i) {
    if (edge == RasterEdge::clamp) return i < 0 ? 0 : i >= size ? size - 1 : static_cast<int>(i);
    return i < 0 ? size - 1 : i >= size ? 0 : static_cast<int>(i);
  };
  return {inside(whole), inside(whole + 1), static_cast<float>(x - whole)};
}

}  // namespace detail

// Bilinear at (u, v), u to the right and v downwards, the corners of the picture at 0 and 1; writes one number per
// channel. u and v are finite.
inline void bilinear(const Raster& raster, double u, double v, RasterEdge edge_u, RasterEdge edge_v, float* result) {
  const auto x = detail::raster_pair(u, raster.width, edge_u), y = detail::raster_pair(v, raster.height, edge_v);
  const float *a = raster.texel(x.first, y.first), *b = raster.texel(x.second, y.first);
  const float *c = raster.texel(x.first, y.second), *d = raster.texel(x.second, y.second);
  for (int k = 0; k < raster.channels; ++k) {
    const float top = a[k] + x.share * (b[k] - a[k]), bottom = c[k] + x.share * (d[k] - c[k]);
    result[k] = top + y.share * (bottom - top);
  }
}

}  // namespace shabon::math
