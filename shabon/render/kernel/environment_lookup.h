// The environment's coefficients for 16 directions at once.
#pragma once

#include "shabon/math/packet_math.h"
#include "shabon/render/kernel/lanes.h"
#include "shabon/scene/environment.h"

namespace shabon::scene {
inline namespace SHABON_REGISTERS {

// Equation (25) for 16 points: the row and column arithmetic together, then four texels each.
inline void bilinear(const EnvironmentPicture& picture, render::LeafRays u, render::LeafRays v, render::LeafRays* rgb) {
  using render::LeafRays;
  constexpr int count = render::leaf_block;
  const float width = static_cast<float>(picture.width), height = static_cast<float>(picture.height);
  LeafRays x = u * width - 0.5f;
  x = select(x < LeafRays(0.0f), x + width, x);
  const LeafRays y = max(LeafRays(0.0f), min(v * height - 0.5f, LeafRays(height - 1)));
  const LeafRays column = min(floor(x), LeafRays(width - 1)), row = floor(y);
  alignas(64) float columns[count], rows[count], fx[count], fy[count];
  column.store(columns), row.store(rows), (x - column).store(fx), (y - row).store(fy);
  alignas(64) float result[3][count];
  const std::size_t stride = 4 * static_cast<std::size_t>(picture.width + 1);
  for (int i = 0; i < count; ++i) {
    using Two = math::packet<float, 8>;
    const auto line = static_cast<std::size_t>(rows[i]);
    const float* top = picture.texels.data() + line * stride + 4 * static_cast<std::size_t>(columns[i]);
    const float* bottom = line + 1 < static_cast<std::size_t>(picture.height) ? top + stride : top;
    const Two above = Two::load(top), below = Two::load(bottom);
    alignas(64) float both[8];
    (above + (below - above) * Two(fy[i])).store(both);
    for (int c = 0; c < 3; ++c) result[c][i] = both[c] + fx[i] * (both[4 + c] - both[c]);
  }
  for (int c = 0; c < 3; ++c) rgb[c] = LeafRays::load(result[c]);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::scene
