// The paths of one generation: geometry side by side for the ray blocks, one Stokes row each.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/optics/packet/stokes_row.h"
#include "shabon/render/kernel/lanes.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using Row = optics::StokesRow<lane_count>;

// While every event of a path lies on one sphere, all its planes of incidence are the same: s and p never mix, the row
// needs no rotation and is kept as its two intensities, q0 = first + second and q1 = first - second.
struct PathState {
  std::uint32_t random = 0;
  std::int32_t from = -1;  // the sphere whose wall the path starts on
  std::int32_t plane = any_plane;
  std::int16_t next_slot = -1;  // film of `from` that lies on the same spot and is met next, or -1
  std::int16_t depth = 0;       // surface events so far
  std::uint16_t pixel = 0;      // within the tile
  std::uint16_t comb = 0;
  float carried = 1;  // mean of q0 over the wavelengths

  static constexpr std::int32_t any_plane = -1;    // no event yet and unpolarised
  static constexpr std::int32_t general_row = -2;  // row.q0..q3 in the frame of `s`
  bool coplanar() const { return plane != general_row; }
};

class Paths {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  // Makes room for `more` paths after the present ones. The arrays are padded so that a block may read past the end.
  void reserve(std::size_t more) {
    const std::size_t needed = size_ + more + leaf_block;
    if (needed <= state.size()) return;
    const std::size_t grown = needed + needed / 2;
    for (auto* numbers : {&ox, &oy, &oz, &dx, &dy, &dz, &sx, &sy, &sz}) numbers->resize(grown);
    state.resize(grown);
    first.resize(grown), second.resize(grown), third.resize(grown), fourth.resize(grown);
  }
  std::size_t push() { return size_++; }
  void resize(std::size_t size) { size_ = size; }

  std::vector<double> ox, oy, oz;  // origin
  std::vector<double> dx, dy, dz;  // unit direction, away from the eye
  std::vector<double> sx, sy, sz;  // the row's s axis, where state.plane is general_row
  std::vector<PathState> state;
  // The row: s and p intensities while coplanar, then q0..q3. Not written before the first event.
  std::vector<Lanes> first, second, third, fourth;

  Row row(std::size_t i) const { return {first[i], second[i], third[i], fourth[i]}; }
  void set_row(std::size_t i, const Row& row) {
    first[i] = row.q0, second[i] = row.q1, third[i] = row.q2, fourth[i] = row.q3;
  }

 private:
  std::size_t size_ = 0;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
