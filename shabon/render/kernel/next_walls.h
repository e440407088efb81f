// The next wall of every path of a generation: in ray blocks where the spheres are few, by the tree where they are
// many.
#pragma once

#include "shabon/render/kernel/paths.h"
#include "shabon/render/kernel/scene_tables.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// `distance` and `sphere` get one entry per path, sphere -1 where the path leaves the scene.
inline void next_walls(const SceneTables& tables, const Paths& paths, double* distance, std::int32_t* sphere) {
  const std::size_t count = paths.size();
  const auto shapes = tables.spheres.spheres();
  if (!tables.spheres.has_few()) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto hit = tables.spheres.next_wall({paths.ox[i], paths.oy[i], paths.oz[i]},
                                                {paths.dx[i], paths.dy[i], paths.dz[i]}, paths.state[i].from);
      distance[i] = hit ? hit->distance : 0;
      sphere[i] = hit ? hit->sphere : geometry::no_sphere;
    }
  } else {
    constexpr double far = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; i += ray_block) {
      double from[ray_block];
      for (int lane = 0; lane < ray_block; ++lane) from[lane] = paths.state[i + static_cast<std::size_t>(lane)].from;
      const Rays from_sphere = Rays::load(from);
      const math::Vec3<Rays> o{Rays::load(&paths.ox[i]), Rays::load(&paths.oy[i]), Rays::load(&paths.oz[i])};
      const math::Vec3<Rays> d{Rays::load(&paths.dx[i]), Rays::load(&paths.dy[i]), Rays::load(&paths.dz[i])};
      Rays nearest(far), met(static_cast<double>(geometry::no_sphere));
      for (std::size_t k = 0; k < shapes.size(); ++k) {
        const math::Vec3<Rays> center{Rays(shapes[k].center.x), Rays(shapes[k].center.y), Rays(shapes[k].center.z)};
        const auto roots = geometry::sphere_roots(o, d, center, Rays(shapes[k].radius));
        const Rays half = sqrt(max(roots.half_chord_squared, Rays(0.0)));
        const Rays near = roots.middle - half;
        Rays t = select(near > Rays(0.0), near, roots.middle + half);
        t = select(roots.half_chord_squared >= Rays(0.0), t, Rays(-1.0));
        const Rays own = roots.middle + roots.middle;  // geometry::chord
        t = select(from_sphere == Rays(double(k)), own, t);
        const auto nearer = (t > Rays(0.0)) & (t < nearest);
        nearest = select(nearer, t, nearest);
        met = select(nearer, Rays(double(k)), met);
      }
      double met_lanes[ray_block];
      met.store(met_lanes);
      nearest.store(distance + i);
      for (int lane = 0; lane < ray_block; ++lane)
        sphere[i + static_cast<std::size_t>(lane)] = static_cast<std::int32_t>(met_lanes[lane]);
    }
  }
  // Films that lie on the same spot of one sphere are met without moving.
  for (std::size_t i = 0; i < count; ++i)
    if (paths.state[i].next_slot >= 0) distance[i] = 0, sphere[i] = paths.state[i].from;
}

// The same for paths that have met the only sphere there is and are still inside: its chords.
inline void chords(const SceneTables& tables, const Paths& paths, double* distance, std::int32_t* sphere) {
  const math::Vec3d c = tables.spheres.spheres()[0].center;
  const math::Vec3<Rays> center{Rays(c.x), Rays(c.y), Rays(c.z)};
  for (std::size_t i = 0; i < paths.size(); i += ray_block) {
    const math::Vec3<Rays> o{Rays::load(&paths.ox[i]), Rays::load(&paths.oy[i]), Rays::load(&paths.oz[i])};
    const math::Vec3<Rays> d{Rays::load(&paths.dx[i]), Rays::load(&paths.dy[i]), Rays::load(&paths.dz[i])};
    const Rays middle = math::dot(d, center - o);
    max(middle + middle, Rays(0.0)).store(distance + i);
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    sphere[i] = 0;
    if (paths.state[i].next_slot >= 0) distance[i] = 0;  // the next film on the same spot
  }
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
