// A pane: coherent groups of layers with thick layers between them, whose passes add without phase, (35). s, p and the
// product of one with the other's conjugate each add up on their own.
#pragma once

#include <vector>

#include "shabon/optics/packet/stack.h"
#include "shabon/render/comb.h"
#include "shabon/render/kernel/lanes.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

struct PaneTable {
  // The outer media are equal and lossless.
  PaneTable(const optics::Stack& stack, const std::vector<Comb>& combs);

  optics::FilmMueller<lane_count> at(std::size_t comb, double cos_i, bool from_back) const;

 private:
  struct Group {
    optics::StackTable forward, backward;  // from the front and from the back
  };
  struct Slab {
    double thickness_nm;
    std::vector<Lanes> log2_loss_per_nm;  // per comb, along the ray
    std::vector<LanesD> index_ratio;      // outside over the slab, per comb
    bool absorbs;
  };
  std::vector<Group> groups_;
  std::vector<Slab> slabs_;  // between the groups
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
