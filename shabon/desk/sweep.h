// A series of films: one layer of a stack takes many thicknesses, everything else stays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

struct Sweep {
  optics::Stack stack;                 // the swept layer's own thickness is not used
  std::size_t layer = 0;               // index into stack.layers
  std::vector<double> thicknesses_nm;  // of that layer; 0..optics::largest_thickness_nm, in any order
  optics::Incidence incidence = {};    // along the normal unless said
  Side side = Side::reflected;
  optics::Interference interference = optics::Interference::airy;
};

// The unpolarised share, (s + p)/2, of every thickness and, within it, every vacuum wavelength (> 0, in nm). Errors: no
// such layer, a thickness out of range, a stack that the model does not know.
Result<std::vector<std::vector<double>>> swept_spectra(const Sweep& sweep, std::span<const double> wavelengths_nm);

// The colour of every thickness (17), with means over nanometres that hold many fringes. The same errors.
Result<std::vector<color::Xyz>> swept_colors(const Sweep& sweep, const color::Illuminant& lamp,
                                             const color::Observer& observer = color::observer_1931());

}  // namespace shabon::desk
