// Directions at a point of a surface, and the Stokes frame of a row as it passes from event to event.
#pragma once

#include "shabon/math/normal_to.h"
#include "shabon/optics/packet/stokes_row.h"
#include "shabon/render/kernel/lanes.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using Row = optics::StokesRow<lane_count>;
using Block = optics::MuellerBlock<lane_count>;

// The s axis of a ray along `direction` on a plane with this normal; at normal incidence any.
inline math::Vec3d s_axis(const math::Vec3d& direction, const math::Vec3d& normal) {
  const math::Vec3d s = math::cross(direction, normal);
  const double size = math::length(s);
  return size > 1e-9 ? s * (1 / size) : math::any_normal_to(direction);
}

// A row and the axis that s means in it; unpolarised rows have no use for it.
struct FramedRow {
  Row row;
  math::Vec3d s;
  bool polarized = false;

  // Turned to another s axis, both normal to `direction`, (15).
  Row in_frame(const math::Vec3d& direction, const math::Vec3d& to) const {
    if (!polarized) return row;
    const double c = math::dot(s, to), k = math::dot(math::cross(s, direction), to), norm = c * c + k * k;
    if (!(norm > 0)) return row;
    return optics::rotated(row, static_cast<float>((c * c - k * k) / norm), static_cast<float>(2 * c * k / norm));
  }
};

inline Row scaled(const Row& row, const Lanes& factor) {
  return {row.q0 * factor, row.q1 * factor, row.q2 * factor, row.q3 * factor};
}

inline Block scaled(const Block& block, const Lanes& factor) {
  return {block.a * factor, block.b * factor, block.c * factor, block.d * factor};
}

inline Row unpolarized(const Lanes& q0) { return {q0, Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)}; }

inline float mean(const Lanes& lanes) { return math::sum(lanes) * (1.0f / lane_count); }

// The frame of a surface: z is the normal on the side the ray comes from.
struct LocalFrame {
  math::Vec3d x, y, z;

  explicit LocalFrame(const math::Vec3d& normal) : z(normal) {
    x = math::any_normal_to(normal);
    y = math::cross(z, x);
  }
  math::Vec3d local(const math::Vec3d& v) const { return {math::dot(v, x), math::dot(v, y), math::dot(v, z)}; }
  math::Vec3d world(const math::Vec3d& v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
