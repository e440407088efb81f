// The packets of the render kernel: 16 wavelengths of one ray, or as many rays at once.
#pragma once

#include "shabon/math/packet_convert.h"
#include "shabon/math/packet_sum.h"
#include "shabon/render/comb.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using Lanes = math::packet<float, lane_count>;  // one value per wavelength
using LanesD = math::packet<double, lane_count>;

inline constexpr int ray_block = 8;  // rays whose geometry is computed together, in double
using Rays = math::packet<double, ray_block>;
inline constexpr int leaf_block = 16;  // rays whose environment is looked up together
using LeafRays = math::packet<float, leaf_block>;

inline constexpr int tile_size = 8;  // pixels; a tile's sums stay in the first-level cache
inline constexpr int tile_pixels = tile_size * tile_size;

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
