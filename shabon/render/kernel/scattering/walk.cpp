#include "shabon/render/kernel/scattering/walk.h"

#include <algorithm>
#include <cmath>

#include "shabon/render/kernel/scattering/walk_parts.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// After this many chances a path goes on only as likely as it carries light.
constexpr int surfaces_before_roulette = 3;

}  // namespace

Walk::Walk(const ScatteringTables& tables)
    : tables_(tables), coefficients_(static_cast<std::size_t>(tables.films.channel_count)) {}

WalkLight Walk::follow(const WalkStart& start, std::vector<double>& direct_coefficients) {
  sample_ = start.sample, comb_ = start.comb;
  hero_ =
      static_cast<int>((mixed_bits(start.seed ^ 0x7F4A7C15u) + start.sample + start.sample / comb_count) % lane_count);
  light_ = {};
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
  Vertex vertex;
  if (ray.film_slot >= 0) {  // the next film on the same spot
    vertex = vertex_at(tables_, ray.origin - ray.direction, ray.direction, 1, shape, comb_, hero_, ray.one_lane);
  } else {
    vertex = vertex_at(tables_, ray.origin, ray.direction, distance, shape, comb_, hero_, ray.one_lane);
  }
  lobes_of(tables_, vertex, shape, ray.film_slot, lobes_);
  if (lobes_.emits) {
    double weight = 1;
    const int object = tables_.shape[static_cast<std::size_t>(shape)].object;
    if (ray.shares_lamps) {
      const double reach = math::length(vertex.at.position - ray.scattered_at);
      const double lamp = tables_.lamps.pdf_object(ray.scattered_at, object, ray.direction, reach);
      weight = ray.density / (ray.density + lamp);
    }
    add(ray, lobes_.emitted, weight);
  }
  if (lobes_.count == 0) return;
  ++counts_.events;
  if (ray.depth >= tables_.scene.render.max_depth) return pass_cut(ray, vertex, shape);
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
  add(ray, radiance, weight);
}

void Walk::add(const Ray& ray, const Lanes& radiance, double weight) {
  const Lanes arriving = ray.row.row.q0 * radiance * Lanes(static_cast<float>(weight));
  const Lanes nothing = arriving - arriving;  // 0 unless infinite or NaN
  if (math::bits(nothing == Lanes(0.0f)) != (1u << lane_count) - 1) {
    ++counts_.dropped;
    return;
  }
  light_.radiance += arriving;
}

// What is lost inside an absorbing solid between two surfaces.
void Walk::fade(Row& row, int space, double distance) const {
  const SpaceTable& table = tables_.spaces[static_cast<std::size_t>(space)];
  if (!table.absorbs) return;
  const Lanes left = math::exp2(-(table.log2_loss_per_unit[comb_] * Lanes(static_cast<float>(distance))));
  row = scaled(row, left);
}

void Walk::meet(const Ray& ray, const Vertex& vertex, int shape) {
  float chance[most_lobes], total = 0;
  bool scatters = false;
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal, any_normal_to(vertex.direction));
  const Row row = ray.row.in_frame(vertex.direction, s);
  for (int k = 0; k < lobes_.count; ++k) {
    Lobe& lobe = lobes_.lobe[k];
    if (lobe.kind == LobeKind::diffuse)
      lobe.estimate = mean(row.q0 * lobe.albedo);
    else if (lobe.kind == LobeKind::embedded)
      lobe.estimate = mean((lobe.block.a * row.q0 + lobe.block.b * row.q1) * lobe.albedo *
                           lobe.coating.table->n_behind_squared[comb_]);
    else
      lobe.estimate = mean(lobe.block.a * row.q0 + lobe.block.b * row.q1);
    lobe.estimate = std::max(0.0f, lobe.estimate * lobe.share);
    total += lobe.estimate;
    scatters = scatters || !is_smooth(lobe.kind);
  }
  if (!(total > 0)) return;
  const bool split = tables_.scene.render.transport == scene::Transport::tree && !ray.by_chance;
  int only = -1;
  for (int k = 0; k < lobes_.count; ++k) chance[k] = split ? 1 : lobes_.lobe[k].estimate / total;
  if (!split) {
    auto u = static_cast<float>(sample_number(sample_, key_for(ray.key, which_lobe))) * total;
    for (int k = 0; k < lobes_.count; ++k) {
      if (lobes_.lobe[k].estimate <= 0) continue;
      only = k;
      u -= lobes_.lobe[k].estimate;
      if (u < 0) break;
    }
  }
  const LocalFrame frame(vertex.normal);
  if (scatters && tables_.lamps.has_lamps()) light_from_lamps(ray, vertex, frame, shape, chance);
  for (int k = 0; k < lobes_.count; ++k) {
    if (only >= 0 && k != only) continue;
    const Lobe lobe = lobes_.lobe[k];
    if (lobe.estimate <= 0) continue;
    const std::uint32_t key = mixed_bits(ray.key + 0x632BE5ABu * static_cast<std::uint32_t>(k + 1));
    if (is_smooth(lobe.kind))
      go_smooth(ray, vertex, lobe, shape, chance[k], key);
    else
      go_rough(ray, vertex, frame, lobe, shape, chance[k], key);
  }
}

int Walk::space_behind(const Lobe& lobe, const Vertex& vertex, int otherwise) const {
  if (lobe.coating.table == nullptr) return otherwise;
  return vertex.from_back ? lobe.coating.table->space_in_front : lobe.coating.table->space_behind;
}

void Walk::go_smooth(const Ray& ray, const Vertex& vertex, const Lobe& lobe, int shape, float chance,
                     std::uint32_t key) {
  Ray next = ray;
  if (!smooth_direction(vertex, lobe, next.direction)) return;
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal, any_normal_to(vertex.direction));
  Row row = optics::through(ray.row.in_frame(vertex.direction, s), lobe.block);
  Lanes factor(lobe.share / chance);
  if (lobe.parts_wavelengths) factor = factor * only_lane(hero_), next.one_lane = true;
  next.row = {scaled(row, factor), s, true};
  next.origin = vertex.at.position;
  next.from = shape;
  next.film_slot = lobe.film_slot;
  if (lobe.kind == LobeKind::refracted) next.space = space_behind(lobe, vertex, ray.space);
  if (lobe.kind != LobeKind::straight) next.shares_lamps = false;
  next.by_chance = ray.by_chance || chance < 1;
  push(next, key);
}

void Walk::go_rough(const Ray& ray, const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe, int shape,
                    float chance, std::uint32_t key) {
  Ray next = ray;
  const SamplePair u = sample_pair(sample_, key_for(key, lobe_direction));
  const double part = sample_number(sample_, key_for(key, lobe_part));
  if (!sample(vertex, frame, lobe, u.first, u.second, part, next.direction)) return;
  const double pdf = density(vertex, frame, lobe, next.direction);
  if (!(pdf > 0)) return;
  next.row = scattered(vertex, frame, lobe, ray.row, next.direction);
  Lanes factor(static_cast<float>(lobe.share / (chance * pdf)));
  if (lobe.parts_wavelengths) factor = factor * only_lane(hero_), next.one_lane = true;
  next.row.row = scaled(next.row.row, factor);
  next.origin = vertex.at.position;
  next.from = shape;
  next.film_slot = -1;
  if (lobe.kind == LobeKind::rough_refracted) next.space = space_behind(lobe, vertex, ray.space);
  next.by_chance = true;
  next.shares_lamps = tables_.lamps.has_lamps();
  next.scattered_at = vertex.at.position;
  next.density = pdf * chance;
  push(next, key);
}

// Equation (26), and more boldly once chance rules: what carries little goes on seldom.
void Walk::push(Ray& ray, std::uint32_t key) {
  ray.key = key;
  ++ray.depth;
  ray.carried = mean(ray.row.row.q0);
  if (!(ray.carried > 0)) return;
  float threshold = static_cast<float>(tables_.scene.render.split_threshold);
  if (ray.by_chance && ray.depth > surfaces_before_roulette) threshold = std::max(threshold, 0.25f);
  if (ray.carried < threshold) {
    const auto u = static_cast<float>(sample_number(sample_, key_for(key, roulette)));
    if (u * threshold >= ray.carried) return;
    ray.row.row = scaled(ray.row.row, Lanes(threshold / ray.carried));
    ray.carried = threshold;
  }
  rays_.push_back(ray);
}

// Equation (27) for what lets light through straight; other surfaces end the path.
void Walk::pass_cut(const Ray& ray, const Vertex& vertex, int shape) {
  ++counts_.cut_paths;
  Block block;
  if (!straight_through(lobes_, block)) return;
  for (int k = 0; k < lobes_.count; ++k)
    if (lobes_.lobe[k].kind == LobeKind::mirror) {
      block.a += lobes_.lobe[k].block.a * Lanes(lobes_.lobe[k].share);
      block.b += lobes_.lobe[k].block.b * Lanes(lobes_.lobe[k].share);
    }
  Ray next = ray;
  const math::Vec3d s = s_axis(vertex.direction, vertex.normal, any_normal_to(vertex.direction));
  block.c = block.a, block.d = Lanes(0.0f);
  next.row = {optics::through(ray.row.in_frame(vertex.direction, s), block), s, true};
  next.origin = vertex.at.position, next.from = shape, next.film_slot = -1;
  next.carried = mean(next.row.row.q0);
  if (next.carried > 0) rays_.push_back(next);
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
