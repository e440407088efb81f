#include "shabon/render/kernel/transport.h"

#include <algorithm>
#include <limits>

#include "shabon/render/kernel/environment_lookup.h"
#include "shabon/render/kernel/film_optics.h"
#include "shabon/render/kernel/next_walls.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

// Camera samples traced together: enough to fill the blocks, few enough for the second-level cache.
constexpr std::size_t generation_size = 256;

// A branch is never taken to carry less than this, so that rounding cannot make it vanish.
constexpr float least_estimate = 1e-9f;

}  // namespace

void TileTransport::add_samples(const Tile& tile, std::uint32_t first, std::uint32_t end) {
  if (!cleared_) {
    for (auto& pixel : sums_)
      for (Lanes& sum : pixel) sum = Lanes(0.0f);
    for (auto& pixel : direct_)
      for (float& sum : pixel) sum = 0;
    cleared_ = true;
  }
  PixelSeeds seeds[tile_pixels];
  tile_seeds(tables_.scene, tile, seeds);
  const TilePixels pixels = split_pixels(tables_.scene, rims_, tile);
  add_pixels(tile, seeds, pixels.plain, pixels.plain_count, first, end, 1.0f);
  add_pixels(tile, seeds, pixels.rim, pixels.rim_count, rim_samples * first, rim_samples * end, 1.0f / rim_samples);
}

void TileTransport::add_pixels(const Tile& tile, const PixelSeeds* seeds, const std::uint16_t* pixels, int count,
                               std::uint32_t first, std::uint32_t end, float weight) {
  if (count == 0) return;
  counts_.camera_samples += static_cast<std::uint64_t>(count) * (end - first);
  for (std::uint32_t sample = first; sample < end;) {
    now_.clear();
    do {
      camera_rays(tables_.scene, start_, tile, seeds, pixels, count, sample++, weight, now_);
    } while (sample < end && now_.size() + static_cast<std::size_t>(count) <= generation_size);
    while (now_.size() > 0) {
      trace_generation();
      std::swap(now_, next_);
    }
  }
}

void TileTransport::take_sums(const Tile& tile, std::vector<std::array<double, 3>>& xyz) {
  xyz.resize(static_cast<std::size_t>(tile.pixels()));
  for (std::size_t i = 0; i < xyz.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      xyz[i][c] = math::sum(math::convert<double>(sums_[i][c])) + double(direct_[i][c]);
  cleared_ = false;
}

void TileTransport::trace_generation() {
  const std::size_t count = now_.size();
  counts_.rays += count;
  distance_.resize(count + leaf_block), sphere_.resize(count + leaf_block);
  now_.reserve(0);
  next_walls(tables_, now_, distance_.data(), sphere_.data());
  sort_out(count);
  for (std::size_t i = 0; i < leaves_.size(); i += leaf_block)
    add_environment(&leaves_[i], static_cast<int>(std::min<std::size_t>(leaf_block, leaves_.size() - i)));
  counts_.film_events += hits_.size();
  next_.clear();
  next_.reserve(2 * hits_.size());
  EventBlock block;
  for (std::size_t i = 0; i < hits_.size(); i += ray_block) {
    const int in_block = static_cast<int>(std::min<std::size_t>(ray_block, hits_.size() - i));
    event_geometry(tables_, now_, &hits_[i], in_block, distance_.data(), sphere_.data(), block);
    for (int lane = 0; lane < in_block; ++lane) film_event(block, lane);
  }
}

// Which paths meet a wall, and which leave the scene; without a branch that nobody can predict.
void TileTransport::sort_out(std::size_t count) {
  hits_.resize(count + 1), leaves_.resize(count + 1);
  std::size_t hits = 0, leaves = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool hit = sphere_[i] >= 0;
    hits_[hits] = i, leaves_[leaves] = i;
    hits += hit, leaves += !hit;
  }
  hits_.resize(hits), leaves_.resize(leaves);
}

void TileTransport::add_environment(const std::uint32_t* leaves, int count) {
  alignas(64) float d[3][leaf_block];
  for (int lane = 0; lane < leaf_block; ++lane) {
    const std::size_t i = leaves[lane < count ? lane : 0];
    d[0][lane] = static_cast<float>(now_.dx[i]);
    d[1][lane] = static_cast<float>(now_.dy[i]);
    d[2][lane] = static_cast<float>(now_.dz[i]);
  }
  coefficients_.resize(static_cast<std::size_t>(tables_.channel_count));
  tables_.scene.environment.coefficients(
      math::Vec3<LeafRays>{LeafRays::load(d[0]), LeafRays::load(d[1]), LeafRays::load(d[2])},
      std::span<LeafRays>(coefficients_));
  for (int lane = 0; lane < count; ++lane) {
    const std::size_t i = leaves[lane];
    if (now_.state[i].depth == 0)
      add_camera_leaf(i, coefficients_.data(), lane);
    else
      add_leaf(i, coefficients_.data(), lane);
  }
}

// The background itself: the same in every wavelength comb, so its colour is known without the lanes.
void TileTransport::add_camera_leaf(std::size_t path, const LeafRays* coefficients, int lane) {
  const PathState& state = now_.state[path];
  for (int k = 0; k < tables_.channel_count; ++k) {
    const float amount = state.carried * coefficients[k][lane];
    for (std::size_t c = 0; c < 3; ++c)
      direct_[state.pixel][c] += amount * tables_.channel_xyz[static_cast<std::size_t>(k)][c];
  }
}

void TileTransport::add_leaf(std::size_t path, const LeafRays* coefficients, int lane) {
  const PathState& state = now_.state[path];
  const Lanes* channels = &tables_.channels[static_cast<std::size_t>(state.comb * tables_.channel_count)];
  Lanes radiance = channels[0] * coefficients[0][lane];
  for (int k = 1; k < tables_.channel_count; ++k) radiance += channels[k] * coefficients[k][lane];
  const Lanes arriving = (state.coplanar() ? now_.first[path] + now_.second[path] : now_.first[path]) * radiance;
  // A number minus itself is 0 unless it is infinite or NaN: such light is left out and counted.
  const Lanes nothing = arriving - arriving;
  if (math::bits(nothing == Lanes(0.0f)) != (1u << lane_count) - 1) {
    ++counts_.dropped;
    return;
  }
  const CombTable& comb = tables_.combs[state.comb];
  for (int c = 0; c < 3; ++c) sums_[state.pixel][c] += arriving * comb.weight[c];
}

void TileTransport::film_event(const EventBlock& block, int lane) {
  const PathState& state = now_.state[block.path[lane]];
  const bool paper = tables_.scene.render.interference == optics::Interference::two_beam;
  if (paper && state.depth >= two_beam_most_events) {
    ++counts_.cut_paths;
    return;
  }
  if (state.depth >= tables_.scene.render.max_depth) return pass_straight(block, lane);
  const bool same_plane = state.plane == block.sphere[lane] || state.plane == PathState::any_plane;
  if (same_plane || paper)
    split_in_plane(block, lane, paper);
  else
    split_general(block, lane);
}

// One branch of a split: the roulette decides whether it goes on; `write` stores its row, scaled.
template <class Write>
void TileTransport::follow(const EventBlock& block, int lane, float carried, bool mirrored, std::int32_t plane,
                           const Write& write) {
  if (carried == 0) return;
  const std::uint32_t random = mixed_bits(now_.state[block.path[lane]].random + (mirrored ? 1 : 2));
  float scale = 1;
  if (survives(carried, random, scale)) write(push_child(block, lane, mirrored, plane, carried, random), scale);
}

// All events so far in one plane: s and p go on side by side.
void TileTransport::split_in_plane(const EventBlock& block, int lane, bool paper) {
  const std::size_t i = block.path[lane];
  const PathState& state = now_.state[i];
  const bool fresh = state.depth == 0;
  const Lanes half(0.5f * state.carried);
  const Lanes s = fresh ? half : now_.first[i], p = fresh ? half : now_.second[i];
  const Powers film = event_powers(tables_, block, lane, state.comb);
  const std::int32_t plane = paper ? PathState::any_plane : block.sphere[lane];
  const Lanes back_s = film.R_s * s, back_p = film.R_p * p;
  const float back = math::sum(back_s + back_p) * (1.0f / lane_count);
  follow(block, lane, back, true, plane, [&](std::size_t child, float scale) {
    next_.first[child] = back_s * scale, next_.second[child] = back_p * scale;
  });
  const Lanes forth_s = film.T_s * s, forth_p = film.T_p * p;
  // Without loss the rest goes forth. The roulette stays unbiased whatever estimate it uses, but never with 0.
  const bool lossless = block.film[lane]->lossless && !paper;
  const float forth =
      lossless ? std::max(state.carried - back, least_estimate) : math::sum(forth_s + forth_p) * (1.0f / lane_count);
  follow(block, lane, forth, false, plane, [&](std::size_t child, float scale) {
    next_.first[child] = forth_s * scale, next_.second[child] = forth_p * scale;
  });
}

void TileTransport::split_general(const EventBlock& block, int lane) {
  const std::size_t i = block.path[lane];
  const PathState& state = now_.state[i];
  Row row = now_.row(i);
  if (state.coplanar()) row = {row.q0 + row.q1, row.q0 - row.q1, Lanes(0.0f), Lanes(0.0f)};
  const Row in_plane = optics::rotated(row, block.cos_2phi[lane], block.sin_2phi[lane]);
  const Mueller film = event_mueller(tables_, block, lane, state.comb);
  const auto follow_part = [&](const optics::MuellerBlock<lane_count>& part, bool mirrored) {
    const Row result = optics::through(in_plane, part);
    const float carried = math::sum(result.q0) * (1.0f / lane_count);
    follow(block, lane, carried, mirrored, PathState::general_row, [&](std::size_t child, float scale) {
      next_.set_row(child, {result.q0 * scale, result.q1 * scale, result.q2 * scale, result.q3 * scale});
      next_.sx[child] = block.sx[lane], next_.sy[child] = block.sy[lane], next_.sz[child] = block.sz[lane];
    });
  };
  follow_part(film.reflected, true);
  follow_part(film.transmitted, false);
}

// Equation (27): where a path is cut, the film passes R + T straight on, so that no energy of a lossless film is lost.
void TileTransport::pass_straight(const EventBlock& block, int lane) {
  const std::size_t i = block.path[lane];
  const PathState& state = now_.state[i];
  ++counts_.cut_paths;
  Row row = now_.row(i);
  if (state.depth == 0 && state.coplanar()) row.q0 = row.q1 = Lanes(0.5f * state.carried);
  const bool lossless = block.film[lane]->lossless;
  const bool same_plane = state.plane == block.sphere[lane] || state.plane == PathState::any_plane;
  const std::int32_t plane = lossless || same_plane ? state.plane : PathState::general_row;
  const std::size_t child = push_child(block, lane, false, plane, state.carried, state.random);
  next_.sx[child] = now_.sx[i], next_.sy[child] = now_.sy[i], next_.sz[child] = now_.sz[i];
  if (!lossless) {
    const Mueller m = event_mueller(tables_, block, lane, state.comb);
    const Lanes kept = m.reflected.a + m.transmitted.a, more_s = m.reflected.b + m.transmitted.b;
    if (same_plane) {
      row.q0 = row.q0 * (kept + more_s), row.q1 = row.q1 * (kept - more_s);
    } else {
      if (state.coplanar()) row = {row.q0 + row.q1, row.q0 - row.q1, Lanes(0.0f), Lanes(0.0f)};
      row = optics::rotated(row, block.cos_2phi[lane], block.sin_2phi[lane]);
      row = optics::through(row, {kept, more_s, kept, Lanes(0.0f)});
      next_.sx[child] = block.sx[lane], next_.sy[child] = block.sy[lane], next_.sz[child] = block.sz[lane];
    }
  }
  next_.set_row(child, row);
}

// Equation (26): below the threshold a branch goes on with probability carried/threshold, and then carries the
// threshold.
bool TileTransport::survives(float& carried, std::uint32_t random, float& scale) const {
  const auto threshold = static_cast<float>(tables_.scene.render.split_threshold);
  if (!(carried < threshold)) return true;
  if (unit_float(mixed_bits(random ^ 0x68BC21EBu)) * threshold >= carried) return false;
  scale = threshold / carried;
  carried = threshold;
  return true;
}

std::size_t TileTransport::push_child(const EventBlock& block, int lane, bool mirrored, std::int32_t plane,
                                      float carried, std::uint32_t random) {
  const std::size_t i = block.path[lane];
  const std::size_t child = next_.push();
  next_.ox[child] = block.px[lane], next_.oy[child] = block.py[lane], next_.oz[child] = block.pz[lane];
  next_.dx[child] = mirrored ? block.rx[lane] : now_.dx[i];
  next_.dy[child] = mirrored ? block.ry[lane] : now_.dy[i];
  next_.dz[child] = mirrored ? block.rz[lane] : now_.dz[i];
  const PathState& parent = now_.state[i];
  PathState& state = next_.state[child];
  state.random = random;
  state.from = block.sphere[lane];
  state.plane = plane;
  const bool inward = block.inward[lane] != mirrored;
  const int slot = block.slot[lane] + (inward ? 1 : -1);
  state.next_slot = static_cast<std::int16_t>(slot >= 0 && slot < block.films[lane] ? slot : -1);
  state.depth = static_cast<std::int16_t>(std::min(parent.depth + 1, int(std::numeric_limits<std::int16_t>::max())));
  state.pixel = parent.pixel;
  state.comb = parent.comb;
  state.carried = carried;
  return child;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
