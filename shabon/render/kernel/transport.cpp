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
    for (bool of_camera = true; now_.size() > 0; of_camera = false) {
      trace_generation(of_camera);
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

void TileTransport::trace_generation(bool of_camera) {
  const std::size_t count = now_.size();
  counts_.rays += count;
  distance_.resize(count + leaf_block), sphere_.resize(count + leaf_block);
  now_.reserve(0);
  if (tables_.lone_sphere && !of_camera)
    chords(tables_, now_, distance_.data(), sphere_.data());
  else
    next_walls(tables_, now_, distance_.data(), sphere_.data());
  sort_out(of_camera);
  counts_.film_events += hits_.size();
  next_.clear();
  next_.reserve(2 * hits_.size()), leaves_.reserve(2 * hits_.size());
  EventBlock block;
  for (std::size_t i = 0; i < hits_.size(); i += ray_block) {
    const int in_block = static_cast<int>(std::min<std::size_t>(ray_block, hits_.size() - i));
    event_geometry(tables_, now_, &hits_[i], in_block, distance_.data(), sphere_.data(), block);
    for (int lane = 0; lane < in_block; ++lane) film_event(block, lane);
  }
  add_background();
  add_leaves();
}

// Which paths meet a wall, and which leave the scene; without a branch that nobody can predict.
void TileTransport::sort_out(bool of_camera) {
  const std::size_t count = now_.size();
  hits_.resize(count + 1), misses_.resize(count + 1);
  std::size_t hits = 0, misses = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool hit = sphere_[i] >= 0;
    hits_[hits] = i, misses_[misses] = i;
    hits += hit, misses += !hit;
  }
  hits_.resize(hits), misses_.resize(misses);
  Leaves& leaves = of_camera ? background_ : leaves_;
  leaves.clear();
  leaves.reserve(misses);
  for (const std::uint32_t i : misses_) {
    const std::size_t leaf = leaves.set_next({now_.dx[i], now_.dy[i], now_.dz[i]}, now_.state[i]);
    leaves.push_if(true);
    if (of_camera)
      leaves.carried[leaf] = now_.state[i].carried;
    else
      leaves.light[leaf] = now_.light(i);
  }
}

// The coefficients of every channel for a block of leaves.
std::span<const LeafRays> TileTransport::coefficients_of(const Leaves& leaves, std::size_t first) {
  coefficients_.resize(static_cast<std::size_t>(tables_.channel_count));
  const math::Vec3<LeafRays> direction{LeafRays::load(&leaves.dx[first]), LeafRays::load(&leaves.dy[first]),
                                       LeafRays::load(&leaves.dz[first])};
  tables_.scene.environment.coefficients(direction, std::span<LeafRays>(coefficients_));
  return coefficients_;
}

// The background itself: the same in every wavelength comb, so its colour is known without the lanes.
void TileTransport::add_background() {
  for (std::size_t first = 0; first < background_.size(); first += leaf_block) {
    const auto coefficients = coefficients_of(background_, first);
    const std::size_t end = std::min(first + leaf_block, background_.size());
    for (std::size_t leaf = first; leaf < end; ++leaf) {
      float* sum = direct_[background_.pixel[leaf]];
      for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const float amount = background_.carried[leaf] * coefficients[k][static_cast<int>(leaf - first)];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += amount * tables_.channel_xyz[k][c];
      }
    }
  }
  background_.clear();
}

void TileTransport::add_leaves() {
  for (std::size_t first = 0; first < leaves_.size(); first += leaf_block) {
    const auto coefficients = coefficients_of(leaves_, first);
    const std::size_t end = std::min(first + leaf_block, leaves_.size());
    for (std::size_t leaf = first; leaf < end; ++leaf) {
      const int lane = static_cast<int>(leaf - first);
      const std::size_t comb = leaves_.comb[leaf];
      const Lanes* channels = &tables_.channels[comb * coefficients.size()];
      Lanes radiance = channels[0] * coefficients[0][lane];
      for (std::size_t k = 1; k < coefficients.size(); ++k) radiance += channels[k] * coefficients[k][lane];
      const Lanes arriving = leaves_.light[leaf] * radiance;
      // A number minus itself is 0 unless it is infinite or NaN: such light is left out and counted.
      const Lanes nothing = arriving - arriving;
      if (math::bits(nothing == Lanes(0.0f)) != (1u << lane_count) - 1) {
        ++counts_.dropped;
        continue;
      }
      for (int c = 0; c < 3; ++c) sums_[leaves_.pixel[leaf]][c] += arriving * tables_.combs[comb].weight[c];
    }
  }
  leaves_.clear();
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

// One branch of a split, equation (26): below the threshold it goes on with probability carried/threshold, and then
// carries the threshold. Nobody can predict which, so there is no jump: a branch that ends is written, and overwritten.
template <class AnyRow>
inline void TileTransport::follow(const EventBlock& block, int lane, float carried, bool mirrored, std::int32_t plane,
                                  const AnyRow& row) {
  const std::uint32_t random = mixed_bits(now_.state[block.path[lane]].random + (mirrored ? 1 : 2));
  const bool ends = unit_float(mixed_bits(random ^ 0x68BC21EBu)) * threshold_ >= carried;
  const float raised = std::max(carried, threshold_);
  send(block, lane, !ends, raised, mirrored, plane, random, row * (raised / carried));
}

// Into the next generation, or to the leaves where no wall can follow. A general row is in the plane of incidence.
template <class AnyRow>
inline void TileTransport::send(const EventBlock& block, int lane, bool goes_on, float carried, bool mirrored,
                                std::int32_t plane, std::uint32_t random, const AnyRow& row) {
  const std::size_t i = block.path[lane];
  const math::Vec3d direction = mirrored ? math::Vec3d{block.rx[lane], block.ry[lane], block.rz[lane]}
                                         : math::Vec3d{now_.dx[i], now_.dy[i], now_.dz[i]};
  if (leaves_for_good(block, lane, mirrored)) {
    leaves_.light[leaves_.set_next(direction, now_.state[i])] = light_of(row);
    leaves_.push_if(goes_on);
    counts_.rays += goes_on;
    return;
  }
  const std::size_t child = next_.size();
  next_.ox[child] = block.px[lane], next_.oy[child] = block.py[lane], next_.oz[child] = block.pz[lane];
  next_.dx[child] = direction.x, next_.dy[child] = direction.y, next_.dz[child] = direction.z;
  next_.state[child] = state_after(block, lane, carried, mirrored, plane, random);
  next_.set_row(child, row);
  if (plane == PathState::general_row)
    next_.sx[child] = block.sx[lane], next_.sy[child] = block.sy[lane], next_.sz[child] = block.sz[lane];
  next_.push_if(goes_on);
}

PathState TileTransport::state_after(const EventBlock& block, int lane, float carried, bool mirrored,
                                     std::int32_t plane, std::uint32_t random) const {
  const PathState& parent = now_.state[block.path[lane]];
  PathState state;
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
  return state;
}

// Out of the outermost film of a sphere that is alone there is no other wall.
bool TileTransport::leaves_for_good(const EventBlock& block, int lane, bool mirrored) const {
  return tables_.lone_sphere && block.inward[lane] == mirrored && block.slot[lane] == 0;
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
  const PlaneRow mirrored{film.R_s * s, film.R_p * p};
  const float back = math::sum(light_of(mirrored)) * (1.0f / lane_count);
  follow(block, lane, back, true, plane, mirrored);
  const PlaneRow through{film.T_s * s, film.T_p * p};
  // Without loss the rest goes forth. The roulette stays unbiased whatever estimate it uses, but never with 0.
  const bool lossless = block.film[lane]->lossless && !paper;
  const float forth =
      lossless ? std::max(state.carried - back, least_estimate) : math::sum(light_of(through)) * (1.0f / lane_count);
  follow(block, lane, forth, false, plane, through);
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
    const float carried = math::sum(light_of(result)) * (1.0f / lane_count);
    follow(block, lane, carried, mirrored, PathState::general_row, result);
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
  const auto go_on = [&](std::int32_t plane, const auto& passed) {
    send(block, lane, true, state.carried, false, plane, state.random, passed);
  };
  Lanes kept(1.0f), more_s(0.0f);
  if (!block.film[lane]->lossless) {
    const Mueller m = event_mueller(tables_, block, lane, state.comb);
    kept = m.reflected.a + m.transmitted.a, more_s = m.reflected.b + m.transmitted.b;
  }
  if (state.plane == block.sphere[lane] || state.plane == PathState::any_plane)
    return go_on(state.plane, PlaneRow{row.q0 * (kept + more_s), row.q1 * (kept - more_s)});
  if (state.coplanar()) row = {row.q0 + row.q1, row.q0 - row.q1, Lanes(0.0f), Lanes(0.0f)};
  row = optics::rotated(row, block.cos_2phi[lane], block.sin_2phi[lane]);
  go_on(PathState::general_row, optics::through(row, {kept, more_s, kept, Lanes(0.0f)}));
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
