// Light transport for one tile of a scene with surfaces: every camera sample is one walk.
#pragma once

#include <array>
#include <vector>

#include "shabon/render/kernel/camera_rays.h"
#include "shabon/render/kernel/scattering/walk.h"
#include "shabon/render/kernel/transport.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

class ScatteringTile {
 public:
  explicit ScatteringTile(const ScatteringTables& tables) : tables_(tables), start_(tables.scene), walk_(tables) {}

  // As those of TileTransport.
  void add_samples(const Tile& tile, std::uint32_t first, std::uint32_t end);
  void take_sums(const Tile& tile, std::vector<std::array<double, 3>>& xyz);
  TransportCounts counts() const;

 private:
  WalkStart start_of(const Tile& tile, int pixel, const PixelSeeds& seeds, std::uint32_t sample) const;
  void add(int pixel, const WalkStart& start, const WalkLight& light);

  const ScatteringTables& tables_;
  const CameraStart start_;
  Walk walk_;
  std::uint64_t camera_samples_ = 0;
  std::array<double, 3> sums_[tile_pixels] = {};
  std::vector<double> direct_;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
