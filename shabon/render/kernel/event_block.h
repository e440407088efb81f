// The geometry of up to eight film events at once: where, which film, how thick, at what angle, and the turn of the
// Stokes frame.
#pragma once

#include <bit>

#include "shabon/optics/packet/free_film.h"
#include "shabon/optics/packet/paper_film.h"
#include "shabon/render/kernel/paths.h"
#include "shabon/render/kernel/scene_tables.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

struct EventBlock {
  int count = 0;
  std::uint32_t path[ray_block];  // index of the path in its generation
  std::int32_t sphere[ray_block];
  std::int16_t slot[ray_block];   // which of the films on this spot, 0 is the outermost
  std::int16_t films[ray_block];  // on this spot
  bool inward[ray_block];         // the ray runs towards the centre
  alignas(64) double px[ray_block], py[ray_block], pz[ray_block];
  alignas(64) double rx[ray_block], ry[ray_block], rz[ray_block];  // mirrored direction
  alignas(64) double cos_i[ray_block], thickness_nm[ray_block];
  alignas(64) double q1_squared[ray_block], q2_squared[ray_block], q2[ray_block];  // where the indices are constant
  alignas(64) double sx[ray_block], sy[ray_block], sz[ray_block];                  // s of the plane of incidence
  float cos_2phi[ray_block], sin_2phi[ray_block];  // from the row's frame to the plane of incidence
  const FilmTable* film[ray_block];
};

namespace detail {

inline math::Vec3<Rays> load3(const double* x, const double* y, const double* z) {
  return {Rays::load(x), Rays::load(y), Rays::load(z)};
}

inline void store3(const math::Vec3<Rays>& v, double* x, double* y, double* z) {
  v.x.store(x), v.y.store(y), v.z.store(z);
}

}  // namespace detail

// The s axis of the path's present row: stored, or for a path that has met one sphere only, normal to its plane.
inline math::Vec3d row_axis(const SceneTables& tables, const Paths& paths, std::size_t i) {
  const PathState& state = paths.state[i];
  if (!state.coplanar()) return {paths.sx[i], paths.sy[i], paths.sz[i]};
  const math::Vec3d d{paths.dx[i], paths.dy[i], paths.dz[i]};
  if (state.plane == PathState::any_plane) return {0, 0, 0};
  const math::Vec3d normal = math::Vec3d{paths.ox[i], paths.oy[i], paths.oz[i]} -
                             tables.scene.spheres[static_cast<std::size_t>(state.plane)].center;
  const math::Vec3d s = math::cross(d, normal);
  const double size = math::length(s);
  return size > 0 ? s * (1 / size) : math::Vec3d{0, 0, 0};
}

// cos and sin of 2 phi from the old s axis to the plane of incidence, equation (15). At normal incidence every plane
// will do and the old one stays.
inline void turn_frame(const SceneTables& tables, const Paths& paths, EventBlock& block, int lane,
                       const math::Vec3d& center) {
  const std::size_t i = block.path[lane];
  const math::Vec3d d{paths.dx[i], paths.dy[i], paths.dz[i]};
  const math::Vec3d old_s = row_axis(tables, paths, i);
  math::Vec3d s = math::cross(d, math::Vec3d{block.px[lane], block.py[lane], block.pz[lane]} - center);
  const double size = math::length(s);
  if (size > 1e-12 * tables.scene.spheres[static_cast<std::size_t>(block.sphere[lane])].radius)
    s = s * (1 / size);
  else if (math::dot(old_s, old_s) > 0.5)
    s = old_s;
  else
    s = math::normalize(math::cross(d, std::abs(d.x) < 0.5 ? math::Vec3d{1, 0, 0} : math::Vec3d{0, 1, 0}));
  const double c = math::dot(old_s, s), k = math::dot(math::cross(old_s, d), s);  // p = (-d) x s = s x d
  const double norm = c * c + k * k;
  block.cos_2phi[lane] = norm > 0 ? static_cast<float>((c * c - k * k) / norm) : 1.0f;
  block.sin_2phi[lane] = norm > 0 ? static_cast<float>(2 * c * k / norm) : 0.0f;
  block.sx[lane] = s.x, block.sy[lane] = s.y, block.sz[lane] = s.z;
}

// The thickness at each event, for all lanes of one film together.
inline void block_thickness(const math::Vec3<Rays>& normal, EventBlock& block) {
  alignas(64) double nm[ray_block];
  for (std::uint32_t left = (1u << block.count) - 1; left != 0;) {
    const FilmTable* film = block.film[std::countr_zero(left)];
    film::thickness_nm(*film->thickness, normal).store(nm);
    for (int lane = 0; lane < block.count; ++lane) {
      if (block.film[lane] != film) continue;
      block.thickness_nm[lane] = nm[lane];
      left &= ~(1u << lane);
    }
  }
}

// Fills the block from `count` paths; `hits` are their indices in the generation.
inline void event_geometry(const SceneTables& tables, const Paths& paths, const std::uint32_t* hits, int count,
                           const double* distance, const std::int32_t* sphere_of, EventBlock& block) {
  block.count = count;
  for (int lane = 0; lane < ray_block; ++lane) {
    const std::uint32_t i = hits[lane < count ? lane : 0];
    block.path[lane] = i, block.sphere[lane] = sphere_of[i];
  }
  const auto of_paths = [&](const auto& numbers) { return math::gathered<Rays>(&numbers[0], block.path); };
  const math::Vec3<Rays> origin{of_paths(paths.ox), of_paths(paths.oy), of_paths(paths.oz)};
  const math::Vec3<Rays> direction{of_paths(paths.dx), of_paths(paths.dy), of_paths(paths.dz)};
  const auto point = origin + direction * of_paths(distance);
  const auto of_spheres = [&](const std::vector<double>& numbers) {
    return tables.lone_sphere ? Rays(numbers[0]) : math::gathered<Rays>(&numbers[0], block.sphere);
  };
  const SphereTable& table = tables.sphere_table;
  const math::Vec3<Rays> center{of_spheres(table.x), of_spheres(table.y), of_spheres(table.z)};
  const auto normal = (point - center) * of_spheres(table.inverse_radius);
  const Rays along = math::dot(direction, normal);
  // Brought back to unit length: a deviation would grow up to 18 times from wall to wall of a bubble.
  const auto turned = direction - normal * (along + along);
  const auto mirrored = turned * (Rays(1.5) - Rays(0.5) * math::dot(turned, turned));
  alignas(64) double n[3][ray_block], along_lanes[ray_block], n2_squared[ray_block] = {};
  detail::store3(point, block.px, block.py, block.pz);
  detail::store3(mirrored, block.rx, block.ry, block.rz);
  detail::store3(normal, n[0], n[1], n[2]);
  along.store(along_lanes);
  min(abs(along), Rays(1.0)).store(block.cos_i);
  for (int lane = 0; lane < count; ++lane) {
    const PathState& state = paths.state[block.path[lane]];
    const scene::Sphere& sphere = tables.scene.spheres[static_cast<std::size_t>(block.sphere[lane])];
    block.inward[lane] = along_lanes[lane] < 0;
    block.slot[lane] = state.next_slot >= 0 ? state.next_slot
                       : block.inward[lane] ? std::int16_t(0)
                                            : static_cast<std::int16_t>(sphere.film_count - 1);
    block.films[lane] = static_cast<std::int16_t>(sphere.film_count);
    block.film[lane] = &tables.films[static_cast<std::size_t>(sphere.first_film + block.slot[lane])];
    n2_squared[lane] = block.film[lane]->n_squared;
    const bool same_plane = state.plane == block.sphere[lane] || state.plane == PathState::any_plane;
    if (!same_plane) turn_frame(tables, paths, block, lane, sphere.center);
  }
  block_thickness(normal, block);
  for (int lane = count; lane < ray_block; ++lane) n2_squared[lane] = n2_squared[0];
  const Rays cos_i = Rays::load(block.cos_i), n1_squared(tables.medium_n_squared);
  const Rays q1_squared = n1_squared * max(cos_i * cos_i, Rays(optics::least_cos2));
  const Rays q2_squared = Rays::load(n2_squared) - n1_squared + q1_squared;
  q1_squared.store(block.q1_squared), q2_squared.store(block.q2_squared);
  sqrt(max(q2_squared, Rays(0.0))).store(block.q2);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
