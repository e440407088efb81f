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

// A cheap 32-bit mixer (Wellons 2018, "Prospecting for hash functions"): one number per path and branch.
std::uint32_t mix(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352Du;
  x ^= x >> 15;
  x *= 0x846CA68Bu;
  return x ^ (x >> 16);
}

Row scaled(const Row& row, float factor, bool coplanar) {
  if (coplanar) return {row.q0 * factor, row.q1 * factor, row.q2, row.q3};
  return {row.q0 * factor, row.q1 * factor, row.q2 * factor, row.q3 * factor};
}

}  // namespace

void TileTransport::add_samples(const Tile& tile, std::uint32_t first, std::uint32_t end) {
  if (!cleared_) {
    for (auto& pixel : sums_)
      for (Lanes& sum : pixel) sum = Lanes(0.0f);
    for (auto& pixel : direct_)
      for (float& sum : pixel) sum = 0;
    cleared_ = true;
  }
  const auto per_sample = static_cast<std::size_t>(tile.pixels());
  for (std::uint32_t sample = first; sample < end;) {
    now_.clear();
    while (sample < end && now_.size() + per_sample <= std::max(generation_size, per_sample))
      camera_rays(tables_.scene, tile, sample++, now_);
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
  hits_.clear(), leaves_.clear();
  for (std::uint32_t i = 0; i < count; ++i) (sphere_[i] >= 0 ? hits_ : leaves_).push_back(i);
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
    for (std::size_t c = 0; c < 3; ++c) direct_[state.pixel][c] += amount * tables_.channel_xyz[static_cast<std::size_t>(k)][c];
  }
}

void TileTransport::add_leaf(std::size_t path, const LeafRays* coefficients, int lane) {
  const PathState& state = now_.state[path];
  const Row& row = now_.row[path];
  const Lanes* channels = &tables_.channels[static_cast<std::size_t>(state.comb * tables_.channel_count)];
  Lanes radiance = channels[0] * coefficients[0][lane];
  for (int k = 1; k < tables_.channel_count; ++k) radiance += channels[k] * coefficients[k][lane];
  const Lanes arriving = (state.coplanar() ? row.q0 + row.q1 : row.q0) * radiance;
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
  const std::size_t i = block.path[lane];
  const PathState& state = now_.state[i];
  const bool paper = tables_.scene.render.interference == optics::Interference::two_beam;
  if (paper && state.depth >= two_beam_most_events) {
    ++counts_.cut_paths;
    return;
  }
  if (state.depth >= tables_.scene.render.max_depth) return pass_straight(block, lane);
  const Row& row = now_.row[i];
  const bool same_plane = state.plane == block.sphere[lane] || state.plane == PathState::any_plane;
  if (same_plane || paper) {
    const Powers p = event_powers(tables_, block, lane, state.comb);
    const Row reflected{p.R_s * row.q0, p.R_p * row.q1, row.q2, row.q3};
    const Row transmitted{p.T_s * row.q0, p.T_p * row.q1, row.q2, row.q3};
    split(block, lane, reflected, transmitted, true, paper ? PathState::any_plane : block.sphere[lane]);
    return;
  }
  const Row whole = state.coplanar() ? Row{row.q0 + row.q1, row.q0 - row.q1, Lanes(0.0f), Lanes(0.0f)} : row;
  const Row in_plane = optics::rotated(whole, block.cos_2phi[lane], block.sin_2phi[lane]);
  const Mueller m = event_mueller(tables_, block, lane, state.comb);
  split(block, lane, optics::through(in_plane, m.reflected), optics::through(in_plane, m.transmitted), false,
        PathState::general_row);
}

// Equation (27): where a path is cut, the film passes R + T straight on, so that no energy of a lossless film is lost.
void TileTransport::pass_straight(const EventBlock& block, int lane) {
  const std::size_t i = block.path[lane];
  const PathState& state = now_.state[i];
  ++counts_.cut_paths;
  const std::size_t child = push_child(block, lane, false, state.plane);
  const FilmTable& film = *block.film[lane];
  next_.row[child] = now_.row[i];
  next_.sx[child] = now_.sx[i], next_.sy[child] = now_.sy[i], next_.sz[child] = now_.sz[i];
  if (film.kind == FilmKind::general) {
    const Mueller m = general_mueller(tables_, film, state.comb, block.cos_i[lane], block.thickness_nm[lane]);
    const Lanes kept = m.reflected.a + m.transmitted.a;
    Row& row = next_.row[child];
    row = {row.q0 * kept, row.q1 * kept, row.q2 * kept, row.q3 * kept};
  }
}

void TileTransport::split(const EventBlock& block, int lane, const Row& reflected, const Row& transmitted,
                          bool coplanar, std::int32_t plane) {
  const PathState& state = now_.state[block.path[lane]];
  const auto mean = [&](const Row& row) {
    return math::sum(coplanar ? row.q0 + row.q1 : row.q0) * (1.0f / lane_count);
  };
  const Row* rows[2] = {&reflected, &transmitted};
  for (int branch = 0; branch < 2; ++branch) {
    float carried = mean(*rows[branch]), scale = 1;
    if (carried == 0) continue;
    const std::uint32_t random = mix(state.random + static_cast<std::uint32_t>(branch) + 1);
    if (!survives(carried, random, scale)) continue;
    const std::size_t child = push_child(block, lane, branch == 0, plane);
    next_.row[child] = scale == 1 ? *rows[branch] : scaled(*rows[branch], scale, coplanar);
    next_.state[child].carried = carried;
    next_.state[child].random = random;
  }
}

// Equation (26): below the threshold a branch goes on with probability carried/threshold, and then carries the threshold.
bool TileTransport::survives(float& carried, std::uint32_t random, float& scale) const {
  const auto threshold = static_cast<float>(tables_.scene.render.split_threshold);
  if (!(carried < threshold)) return true;
  if (unit_float(mix(random ^ 0x68BC21EBu)) * threshold >= carried) return false;
  scale = threshold / carried;
  carried = threshold;
  return true;
}

std::size_t TileTransport::push_child(const EventBlock& block, int lane, bool mirrored, std::int32_t plane) {
  const std::size_t i = block.path[lane];
  const std::size_t child = next_.push();
  next_.ox[child] = block.px[lane], next_.oy[child] = block.py[lane], next_.oz[child] = block.pz[lane];
  if (mirrored)
    next_.dx[child] = block.rx[lane], next_.dy[child] = block.ry[lane], next_.dz[child] = block.rz[lane];
  else
    next_.dx[child] = now_.dx[i], next_.dy[child] = now_.dy[i], next_.dz[child] = now_.dz[i];
  if (plane == PathState::general_row)
    next_.sx[child] = block.sx[lane], next_.sy[child] = block.sy[lane], next_.sz[child] = block.sz[lane];
  PathState& state = next_.state[child];
  state = now_.state[i];
  state.depth = static_cast<std::int16_t>(std::min(state.depth + 1, int(std::numeric_limits<std::int16_t>::max())));
  state.from = block.sphere[lane];
  state.plane = plane;
  const bool inward = block.inward[lane] != mirrored;
  const int films = tables_.scene.spheres[static_cast<std::size_t>(block.sphere[lane])].film_count;
  const int slot = block.slot[lane] + (inward ? 1 : -1);
  state.next_slot = static_cast<std::int16_t>(slot >= 0 && slot < films ? slot : -1);
  return child;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
