// The paths of one generation: geometry side by side for the ray blocks, one Stokes row each.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/math/vec.h"
#include "shabon/optics/packet/stokes_row.h"
#include "shabon/render/kernel/lanes.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using Row = optics::StokesRow<lane_count>;
inline Row operator*(const Row& row, float scale) {
  return {row.q0 * scale, row.q1 * scale, row.q2 * scale, row.q3 * scale};
}
inline Lanes light_of(const Row& row) { return row.q0; }

// The row of a path whose events all lie in one plane: the intensities of s and p.
struct PlaneRow {
  Lanes s, p;
};
inline PlaneRow operator*(const PlaneRow& row, float scale) { return {row.s * scale, row.p * scale}; }
inline Lanes light_of(const PlaneRow& row) { return row.s + row.p; }

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
  // Takes in the path written at size(), or leaves its place to the next.
  void push_if(bool goes_on) { size_ += goes_on; }
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
  void set_row(std::size_t i, const PlaneRow& row) { first[i] = row.s, second[i] = row.p; }

  // The intensity that path i carries, whatever its row.
  Lanes light(std::size_t i) const { return state[i].coplanar() ? first[i] + second[i] : first[i]; }

 private:
  std::size_t size_ = 0;
};

// Paths that have left the scene for good: where they look, and what of its light they bring to which pixel.
class Leaves {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  // Makes room for `more` leaves, and for a block to read past the end.
  void reserve(std::size_t more) {
    const std::size_t needed = size_ + more + leaf_block;
    if (needed <= pixel.size()) return;
    const std::size_t grown = needed + needed / 2;
    for (auto* numbers : {&dx, &dy, &dz, &carried}) numbers->resize(grown);
    pixel.resize(grown), comb.resize(grown), light.resize(grown);
  }
  // Writes the leaf at size(), but for its light, and tells its place.
  std::size_t set_next(const math::Vec3d& direction, const PathState& of) {
    dx[size_] = static_cast<float>(direction.x), dy[size_] = static_cast<float>(direction.y);
    dz[size_] = static_cast<float>(direction.z);
    pixel[size_] = of.pixel, comb[size_] = of.comb;
    return size_;
  }
  void push_if(bool goes_on) { size_ += goes_on; }

  std::vector<float> dx, dy, dz;  // unit direction
  std::vector<std::uint16_t> pixel, comb;
  std::vector<float> carried;  // of light that has met no film, the same at every wavelength
  std::vector<Lanes> light;    // of any other

 private:
  std::size_t size_ = 0;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
