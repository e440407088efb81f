// Light from lamps at a surface that scatters, and the way there.
#include "shabon/render/kernel/scattering/walk.h"
#include "shabon/render/kernel/scattering/walk_parts.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// A surface met on the way to a lamp is not looked for beyond this many.
constexpr int most_crossings = 64;

}  // namespace

// One lamp, one shadow ray, all lobes; each lobe weighs its light against its own scattered rays, (58).
void Walk::light_from_lamps(const Ray& ray, const Vertex& vertex, const LocalFrame& frame, int shape) {
  const double u_lamp = sample_number(sample_, key_for(ray.key, which_lamp));
  const SamplePair u = sample_pair(sample_, key_for(ray.key, lamp_direction));
  const auto lamp = tables_.lamps.sample(vertex.at.position, u_lamp, u.first, u.second);
  if (!lamp || !(lamp->pdf > 0)) return;
  FramedRow rows[most_lobes];
  int count = 0, space = ray.space;
  bool alone = ray.one_lane;
  for (int k = 0; k < lobes_.count; ++k) {
    const Lobe& lobe = lobes_.lobe[k];
    if (is_smooth(lobe.kind)) continue;
    const double pdf = density(vertex, frame, lobe, lamp->direction);
    if (!(pdf > 0)) continue;
    FramedRow row = scattered(vertex, frame, lobe, ray.row, lamp->direction);
    Lanes factor(static_cast<float>(lobe.share / (lamp->pdf + pdf * lobe.chance)));
    if (lobe.parts_wavelengths) factor = factor * only_lane(hero_), alone = true;
    row.row = scaled(row.row, factor);
    if (lobe.kind == LobeKind::rough_refracted) space = space_behind(lobe, vertex, ray.space);
    rows[count++] = row;
  }
  if (count == 0) return;
  Lanes radiance;
  ++counts_.shadow_rays;
  if (!reach_lamp(vertex, shape, *lamp, space, radiance)) return;
  Lanes sum(0.0f);
  for (int k = 0; k < count; ++k) {
    FramedRow row = rows[k];
    for (const Crossing& crossing : crossings_)
      row = {optics::through(row.in_frame(lamp->direction, crossing.s), crossing.block), crossing.s, true};
    sum += row.row.q0;
  }
  add(sum, radiance, 1, alone);
}

// Whether nothing but films and the like stand between the surface and the lamp; lists them.
bool Walk::reach_lamp(const Vertex& vertex, int start, const LampDirection& lamp, int space, Lanes& radiance) {
  crossings_.clear();
  Lanes passed(1.0f);
  math::Vec3d origin = vertex.at.position;
  int from = start, slot = -1;
  double left = lamp.distance;
  for (int met = 0; met < most_crossings; ++met) {
    int shape = from;
    double distance = 0;
    if (slot < 0) {
      const auto hit = tables_.shapes.next(origin, lamp.direction, from);
      // The lamp itself ends the way; beside its own surface there is nothing to look for.
      if (!hit) {
        if (lamp.object >= 0) return false;
        radiance = environment(lamp.direction) * passed;
        return true;
      }
      shape = hit->shape, distance = hit->distance;
    }
    const Vertex on_the_way = vertex_at(tables_, origin, lamp.direction, distance, shape, comb_, hero_, false);
    Row faded = unpolarized(Lanes(1.0f));
    fade(faded, space, distance);
    passed = passed * faded.q0;
    left -= distance;
    lobes_of(tables_, on_the_way, shape, slot, lobes_on_the_way_);
    if (lamp.object >= 0 && tables_.shape[static_cast<std::size_t>(shape)].object == lamp.object) {
      constexpr double near = 1e-6;
      if (!lobes_on_the_way_.emits || std::abs(left) > near * (1 + lamp.distance)) return false;
      radiance = lobes_on_the_way_.emitted * passed;
      return true;
    }
    Crossing crossing;
    if (!straight_through(lobes_on_the_way_, crossing.block)) return false;
    crossing.s = s_axis(lamp.direction, on_the_way.normal);
    crossings_.push_back(crossing);
    slot = -1;
    for (int k = 0; k < lobes_on_the_way_.count; ++k)
      if (const Lobe& lobe = lobes_on_the_way_.lobe[k]; lobe.kind == LobeKind::straight)
        slot = lobe.film_slot, space = space_behind(lobe, on_the_way, space);
    origin = on_the_way.at.position, from = shape;
  }
  return false;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
