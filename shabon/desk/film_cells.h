// The share of light over whole nanometres: what (17) sums where a film's fringes are finer than its steps. Inside the
// room only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shabon/color/spectrum.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/kernel/sweep_table.h"
#include "shabon/desk/sweep.h"

namespace shabon::desk {

// Whether (45) holds: one system of waves from the first medium to the last.
bool can_be_cut(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence);

// One nanometre of a stack that passed check_computable(), its wavelengths looked at one by one.
double cell_share(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence, Side side,
                  double wavelength_nm);

// A sweep that can be cut, over the nanometres 360, 361, ... 830.
class SweptCells {
 public:
  explicit SweptCells(const Sweep& sweep);

  // Whether one wavelength stands for each nanometre at this thickness; then table() is all there is to it.
  bool resolved(double thickness_nm) const;
  const SweepTable& table() const { return table_; }

  // The mean share of every nanometre at this thickness.
  color::Spectrum shares(double thickness_nm) const;

 private:
  const Sweep& sweep_;
  std::vector<double> wavelengths_nm_;  // of the table: one or more a nanometre
  std::vector<std::size_t> first_;      // the first of each nanometre, and the end
  SweepTable table_;
  std::vector<double> fringes_per_nm_;       // of the swept layer within the part of its nanometre, for each nm of it
  double most_fringes_per_nm_of_layer_ = 0;  // the largest of them
};

}  // namespace shabon::desk
