// Light transport for one tile: splitting at every film, equations (26) and (27).
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/render/kernel/camera_rays.h"
#include "shabon/render/kernel/event_block.h"
#include "shabon/render/kernel/paths.h"
#include "shabon/render/kernel/rim.h"
#include "shabon/render/kernel/scene_tables.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

struct TransportCounts {
  std::uint64_t camera_samples = 0, rays = 0, film_events = 0, cut_paths = 0, dropped = 0;
};

// The paper's recursion does not end by itself beyond 83.25 degrees: a path of more events than this is dropped.
inline constexpr int two_beam_most_events = 16;

class TileTransport {
 public:
  explicit TileTransport(const SceneTables& tables)
      : tables_(tables),
        start_(tables.scene),
        rims_(rim_cones(tables.scene)),
        threshold_(static_cast<float>(tables.scene.render.split_threshold)) {}

  // Adds the samples [first, end) of every pixel of the tile to its sums.
  void add_samples(const Tile& tile, std::uint32_t first, std::uint32_t end);

  // The sums of the tile's pixels since the last call, XYZ; starts again from zero.
  void take_sums(const Tile& tile, std::vector<std::array<double, 3>>& xyz);

  const TransportCounts& counts() const { return counts_; }

 private:
  void add_pixels(const Tile& tile, const PixelSeeds* seeds, const std::uint16_t* pixels, int count,
                  std::uint32_t first, std::uint32_t end, float weight);
  void trace_generation(bool of_camera);
  void sort_out(bool of_camera);
  void add_background();
  void add_leaves();
  std::span<const LeafRays> coefficients_of(const Leaves& leaves, std::size_t first);
  void film_event(const EventBlock& block, int lane);
  template <class AnyRow>
  void follow(const EventBlock& block, int lane, float carried, bool mirrored, std::int32_t plane, const AnyRow& row);
  template <class AnyRow>
  void send(const EventBlock& block, int lane, bool goes_on, float carried, bool mirrored, std::int32_t plane,
            std::uint32_t random, const AnyRow& row);
  bool leaves_for_good(const EventBlock& block, int lane, bool mirrored) const;
  PathState state_after(const EventBlock& block, int lane, float carried, bool mirrored, std::int32_t plane,
                        std::uint32_t random) const;
  void split_in_plane(const EventBlock& block, int lane, bool paper);
  void split_general(const EventBlock& block, int lane);
  void pass_straight(const EventBlock& block, int lane);

  const SceneTables& tables_;
  const CameraStart start_;
  const std::vector<RimCone> rims_;
  const float threshold_;
  TransportCounts counts_;
  Paths now_, next_;
  std::vector<double> distance_;
  std::vector<std::int32_t> sphere_;
  std::vector<std::uint32_t> hits_, misses_;
  Leaves background_, leaves_;
  std::vector<LeafRays> coefficients_;
  Lanes sums_[tile_pixels][3];
  float direct_[tile_pixels][3];
  bool cleared_ = false;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
