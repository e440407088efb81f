#include "shabon/render/kernel/scattering/walk.h"

#include <algorithm>
#include <cmath>

#include "shabon/render/kernel/scattering/walk_parts.h"
#include "shabon/render/kernel/transport.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// A path that has met so many surfaces and is scattered again goes on only as likely as it carries this much. What a
// film or glass mirrors carries less and may show a lamp, which nothing else finds: it goes on down to less.
constexpr int surfaces_before_roulette = 3;
constexpr float least_carried_by_scattering = 0.25f, least_carried_after_chance = 0.005f;

// A tree that has met so many surfaces raises its threshold by as much as it grows beyond them: what it costs then
// grows as the square root. Nested solids halve their time per squared error by it; other scenes stay below.
constexpr float events_before_thrift = 64;

// The share of paths that goes on at each event after max_depth ones, where (27) does not end them.
constexpr float goes_on_at_depth = 15.0f / 16;

}  // namespace

Walk::Walk(const ScatteringTables& tables)
    : tables_(tables),
      coefficients_(static_cast<std::size_t>(tables.films.channel_count)),
      single_path_(tables.scene.render.transport == scene::Transport::path) {}

WalkLight Walk::follow(const WalkStart& start, std::vector<double>& direct_coefficients) {
  sample_ = start.sample, comb_ = start.comb;
  hero_ =
      static_cast<int>((mixed_bits(start.seed ^ 0x7F4A7C15u) + start.sample + start.sample / comb_count) % lane_count);
  light_ = {};
  events_before_ = counts_.events;
  rays_.clear();
  Ray first;
  first.origin = start.origin, first.direction = start.direction;
  first.row = start.row, first.carried = start.carried;
  first.space = start.space.value_or(tables_.camera_space);
  first.key = start.seed;
  rays_.push_back(first);
  while (!rays_.empty()) {
    Ray ray = rays_.back();
    rays_.pop_back();
    step(ray);
  }
  if (light_.direct) direct_coefficients = coefficients_;
  return light_;
}

void Walk::step(Ray& ray) {
  ++counts_.rays;
  int shape = ray.from;
  double distance = 0;
  if (ray.film_slot < 0) {
    const auto hit = tables_.shapes.next(ray.origin, ray.direction, ray.from);
    if (!hit) return leave(ray);
    shape = hit->shape, distance = hit->distance;
    fade(ray.row.row, ray.space, distance);
  }
  const Vertex vertex = vertex_at(tables_, ray.origin, ray.direction, distance, shape, comb_, hero_, ray.one_lane);
  lobes_of(tables_, vertex, shape, ray.film_slot, lobes_);
  if (lobes_.emits) {
    double weight = 1;
    const int object = tables_.shape[static_cast<std::size_t>(shape)].object;
    if (ray.shares_lamps) {
      const double reach = math::length(vertex.at.position - ray.scattered_at);
      const double lamp = tables_.lamps.pdf_object(ray.scattered_at, object, ray.direction, reach);
      weight = ray.density / (ray.density + lamp);
    }
    add(ray.row.row.q0, lobes_.emitted, weight, ray.one_lane);
  }
  if (lobes_.count == 0) return;
  ++counts_.events;
  const bool paper = tables_.scene.render.interference == optics::Interference::two_beam;
  if (paper && ray.depth >= two_beam_most_events && tables_.shape[static_cast<std::size_t>(shape)].film_count > 0) {
    ++counts_.cut_paths;
    return;
  }
  if (ray.depth >= tables_.scene.render.max_depth && !outlives_depth(ray, vertex, shape)) return;
  meet(ray, vertex, shape);
}

Lanes Walk::environment(const math::Vec3d& direction) {
  tables_.scene.environment.coefficients<double>(direction, coefficients_);
  const Lanes* channels = &tables_.films.channels[comb_ * coefficients_.size()];
  Lanes radiance(0.0f);
  for (std::size_t k = 0; k < coefficients_.size(); ++k)
    radiance += channels[k] * Lanes(static_cast<float>(coefficients_[k]));
  return radiance;
}

void Walk::leave(const Ray& ray) {
  const Lanes radiance = environment(ray.direction);
  if (ray.depth == 0 && ray.space == 0) {
    light_.direct = true;
    light_.direct_carried = ray.carried;
    return;
  }
  double weight = 1;
  if (ray.shares_lamps) {
    const double lamp = tables_.lamps.pdf_infinity(ray.scattered_at, ray.direction);
    weight = ray.density / (ray.density + lamp);
  }
  add(ray.row.row.q0, radiance, weight, ray.one_lane);
}

void Walk::add(const Lanes& q0, const Lanes& radiance, double weight, bool alone) {
  const Lanes arriving = q0 * radiance * Lanes(static_cast<float>(weight));
  const Lanes nothing = arriving - arriving;  // 0 unless infinite or NaN
  if (math::bits(nothing == Lanes(0.0f)) != (1u << lane_count) - 1) {
    ++counts_.dropped;
    return;
  }
  (alone ? light_.alone : light_.radiance) += arriving;
}

// What is lost inside an absorbing solid between two surfaces.
void Walk::fade(Row& row, int space, double distance) const {
  const SpaceTable& table = tables_.spaces[static_cast<std::size_t>(space)];
  if (!table.absorbs) return;
  const Lanes left = math::exp2(-(table.log2_loss_per_unit[comb_] * Lanes(static_cast<float>(distance))));
  row = scaled(row, left);
}

// About how much of the row goes on by each lobe.
void Walk::estimate(const Ray& ray, const Vertex& vertex) {
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal);
  const Row row = ray.row.in_frame(vertex.direction, s);
  for (int k = 0; k < lobes_.count; ++k) {
    Lobe& lobe = lobes_.lobe[k];
    Lanes onward = row.q0 * lobe.albedo;
    if (lobe.kind != LobeKind::diffuse) onward = lobe.block.a * row.q0 + lobe.block.b * row.q1;
    if (lobe.kind == LobeKind::embedded) onward = onward * lobe.albedo * lobe.coating.table->n_behind_squared[comb_];
    lobe.estimate = std::max(0.0f, mean(onward) * lobe.share);
  }
}

// Follows one of the lobes that `is_drawn` names, by what they carry; leaves the others as they are.
template <class IsDrawn>
void Walk::draw_one(const IsDrawn& is_drawn, double u01) {
  float total = 0;
  for (int k = 0; k < lobes_.count; ++k)
    if (is_drawn(lobes_.lobe[k])) total += lobes_.lobe[k].estimate;
  float u = static_cast<float>(u01) * total;
  Lobe* drawn = nullptr;
  for (int k = 0; k < lobes_.count; ++k) {
    Lobe& lobe = lobes_.lobe[k];
    if (!is_drawn(lobe) || lobe.estimate <= 0) continue;
    lobe.chance = lobe.estimate / total, lobe.followed = false;
    if (u >= 0) drawn = &lobe;
    u -= lobe.estimate;
  }
  if (drawn != nullptr) drawn->followed = true;
}

// The tree follows all lobes until light has scattered, then all smooth ones and one of the others; of smooth ones that
// carry less than the threshold it follows one, in place of (26) for each. A single path follows one of all.
void Walk::choose(const Ray& ray) {
  for (int k = 0; k < lobes_.count; ++k) {
    Lobe& lobe = lobes_.lobe[k];
    lobe.followed = lobe.estimate > 0;
    lobe.chance = 1;
  }
  const auto number = [&](std::uint32_t purpose) { return sample_number(sample_, key_for(ray.key, purpose)); };
  if (single_path_) return draw_one([](const Lobe&) { return true; }, number(which_lobe));
  const float least = std::max(ray.by_chance ? least_carried_after_chance : 0, threshold());
  const auto is_small = [&](const Lobe& lobe) { return is_smooth(lobe.kind) && lobe.estimate < least; };
  const auto is_rough = [](const Lobe& lobe) { return !is_smooth(lobe.kind); };
  const Lobe *first = lobes_.lobe, *end = first + lobes_.count;
  if (std::count_if(first, end, is_small) > 1) draw_one(is_small, number(which_small));
  if (ray.by_chance && std::count_if(first, end, is_rough) > 1) draw_one(is_rough, number(which_lobe));
}

void Walk::meet(const Ray& ray, const Vertex& vertex, int shape) {
  estimate(ray, vertex);
  choose(ray);
  const LocalFrame frame(vertex.normal);
  const auto scatters = [](const Lobe& lobe) { return !is_smooth(lobe.kind) && lobe.estimate > 0; };
  if (tables_.lamps.has_lamps() && std::any_of(lobes_.lobe, lobes_.lobe + lobes_.count, scatters))
    light_from_lamps(ray, vertex, frame, shape);
  for (int k = 0; k < lobes_.count; ++k) {
    const Lobe& lobe = lobes_.lobe[k];
    if (!lobe.followed) continue;
    const std::uint32_t key = mixed_bits(ray.key + 0x632BE5ABu * static_cast<std::uint32_t>(k + 1));
    if (is_smooth(lobe.kind))
      go_smooth(ray, vertex, lobe, shape, key);
    else
      go_rough(ray, vertex, frame, lobe, shape, key);
  }
}

int Walk::space_behind(const Lobe& lobe, const Vertex& vertex, int otherwise) const {
  if (lobe.coating.table == nullptr) return otherwise;
  return vertex.from_back ? lobe.coating.table->space_in_front : lobe.coating.table->space_behind;
}

void Walk::go_smooth(const Ray& ray, const Vertex& vertex, const Lobe& lobe, int shape, std::uint32_t key) {
  Ray next = ray;
  if (!smooth_direction(vertex, lobe, next.direction)) return;
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal);
  Row row = optics::through(ray.row.in_frame(vertex.direction, s), lobe.block);
  Lanes factor(lobe.share / lobe.chance);
  if (lobe.parts_wavelengths) factor = factor * only_lane(hero_), next.one_lane = true;
  next.row = {scaled(row, factor), s, true};
  next.origin = vertex.at.position;
  next.from = shape;
  next.film_slot = lobe.film_slot;
  if (lobe.kind != LobeKind::mirror) next.space = space_behind(lobe, vertex, ray.space);
  if (lobe.kind != LobeKind::straight) next.shares_lamps = false;
  next.by_chance = ray.by_chance || (single_path_ && lobe.chance < 1);
  push(next, key, ray.by_chance ? least_carried_after_chance : 0);
}

void Walk::go_rough(const Ray& ray, const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, int shape,
                    std::uint32_t key) {
  Ray next = ray;
  const SamplePair u = sample_pair(sample_, key_for(key, lobe_direction));
  const double part = sample_number(sample_, key_for(key, lobe_part));
  if (!sample(vertex, frame, lobe, u.first, u.second, part, next.direction)) return;
  const double pdf = density(vertex, frame, lobe, next.direction);
  if (!(pdf > 0)) return;
  next.row = scattered(vertex, frame, lobe, ray.row, next.direction);
  Lanes factor(static_cast<float>(lobe.share / (lobe.chance * pdf)));
  if (lobe.parts_wavelengths) factor = factor * only_lane(hero_), next.one_lane = true;
  next.row.row = scaled(next.row.row, factor);
  next.origin = vertex.at.position;
  next.from = shape;
  next.film_slot = -1;
  if (lobe.kind == LobeKind::rough_refracted) next.space = space_behind(lobe, vertex, ray.space);
  next.by_chance = true;
  next.shares_lamps = tables_.lamps.has_lamps();
  next.scattered_at = vertex.at.position;
  next.density = pdf * lobe.chance;
  push(next, key, ray.by_chance && ray.depth >= surfaces_before_roulette ? least_carried_by_scattering : 0);
}

// The threshold of (26) for this tree, whose branches are the cheaper the more there were. What was met so far does not
// depend on the choices that are to come: any such threshold leaves the mean as it is.
float Walk::threshold() const {
  const float growth = static_cast<float>(counts_.events - events_before_) / events_before_thrift;
  return std::min(1.0f, static_cast<float>(tables_.scene.render.split_threshold) * std::max(1.0f, growth));
}

// Equation (26), with `least` in place of the threshold where that is larger.
void Walk::push(Ray& ray, std::uint32_t key, float least) {
  ray.key = key;
  ++ray.depth;
  ray.carried = mean(ray.row.row.q0);
  if (!(ray.carried > 0)) return;
  const float threshold = std::max(least, this->threshold());
  if (ray.carried < threshold) {
    const auto u = static_cast<float>(sample_number(sample_, key_for(key, roulette)));
    if (u * threshold >= ray.carried) return;
    ray.row.row = scaled(ray.row.row, Lanes(threshold / ray.carried));
    ray.carried = threshold;
  }
  rays_.push_back(ray);
}

// After max_depth events. What does nothing but mirror and let through straight lets all of it through, (27): false,
// the rest is done. Elsewhere, as inside solids that trap light, the path goes on by roulette.
bool Walk::outlives_depth(Ray& ray, const Vertex& vertex, int shape) {
  const auto is_plain = [](const Lobe& lobe) {
    return lobe.kind == LobeKind::mirror || lobe.kind == LobeKind::straight;
  };
  Block block;
  if (std::all_of(lobes_.lobe, lobes_.lobe + lobes_.count, is_plain) && straight_through(lobes_, block)) {
    pass_cut(ray, vertex, shape, block);
    return false;
  }
  if (sample_number(sample_, key_for(ray.key, roulette_at_depth)) >= double{goes_on_at_depth}) return false;
  ray.row.row = scaled(ray.row.row, Lanes(1 / goes_on_at_depth));
  ray.carried /= goes_on_at_depth;
  return true;
}

void Walk::pass_cut(const Ray& ray, const Vertex& vertex, int shape, Block block) {
  ++counts_.cut_paths;
  Ray next = ray;
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal);
  block.c = block.a, block.d = Lanes(0.0f);
  next.row = {optics::through(ray.row.in_frame(vertex.direction, s), block), s, true};
  next.origin = vertex.at.position, next.from = shape, next.film_slot = -1;
  next.carried = mean(next.row.row.q0);
  if (next.carried > 0) rays_.push_back(next);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
