// What walks to lamps and walks by chance have in common.
#pragma once

#include <algorithm>
#include <cmath>

#include "shabon/render/kernel/scattering/lobe.h"
#include "shabon/render/kernel/scattering/sampler.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// What a choice of a branch is for.
enum Purpose : std::uint32_t {
  which_lobe = 1,
  which_lamp,
  lamp_direction,
  lobe_direction,
  lobe_part,
  roulette,
  which_small,
  roulette_at_depth
};

constexpr std::uint32_t key_for(std::uint32_t branch, std::uint32_t purpose) {
  return mixed_bits(branch + purpose * 0x9E3779B9u);
}

inline Lanes only_lane(int lane) {
  alignas(64) float values[lane_count] = {};
  values[lane] = lane_count;
  return Lanes::load(values);
}

// Where a ray meets a shape; with the distance 0 another film on the spot where it stands.
inline Vertex vertex_at(const ScatteringTables& tables, const math::Vec3d& origin, const math::Vec3d& direction,
                        double distance, int shape, std::size_t comb, int hero, bool one_lane) {
  Vertex vertex;
  const double back = distance > 0 ? 0 : 1;
  vertex.at = geometry::surface_at(tables.shapes.shapes()[static_cast<std::size_t>(shape)], origin - direction * back,
                                   direction, distance + back);
  vertex.direction = direction;
  const double along = math::dot(direction, vertex.at.normal);
  vertex.from_back = along > 0;
  vertex.normal = vertex.from_back ? -vertex.at.normal : vertex.at.normal;
  vertex.cos_o = std::min(1.0, std::abs(along));
  vertex.comb = comb, vertex.hero = hero, vertex.one_lane = one_lane;
  return vertex;
}

// All that a surface lets through straight, in the frame of its plane of incidence.
inline bool straight_through(const Lobes& lobes, Block& block) {
  bool any = false;
  for (int k = 0; k < lobes.count; ++k) {
    const Lobe& lobe = lobes.lobe[k];
    if (lobe.kind != LobeKind::straight) continue;
    const Lanes share(lobe.share);
    if (!any) block = {Lanes(0.0f), Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)};
    block = {block.a + lobe.block.a * share, block.b + lobe.block.b * share, block.c + lobe.block.c * share,
             block.d + lobe.block.d * share};
    any = true;
  }
  return any;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
