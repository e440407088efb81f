// What a plane stack reflects, transmits and absorbs. Double precision throughout.
#pragma once

#include <span>

#include "shabon/base/result.h"
#include "shabon/color/spectrum.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

// Whether film_powers() can compute the stack under this model. The error says what is missing.
Status check_computable(const optics::Stack& stack, optics::Interference interference);

// R and T per polarisation at a vacuum wavelength (> 0), for a stack that passed check_computable(). A bare interface
// counts as a film of no thickness. `two_beam` is unclamped: R may exceed 1, and R + T need not be 1 without loss.
optics::Powers film_powers(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                           double wavelength_nm);

// One warning for every medium that is asked for beyond the wavelengths its source covers.
Diagnostics range_warnings(const optics::Stack& stack, std::span<const double> wavelengths_nm);

enum class Side { reflected, transmitted };

// The unpolarised share of light, (s + p)/2, on one side.
double unpolarised(const optics::Powers& powers, Side side);

// The same at 360, 361, ... 830 nm, as (17) sums it: where the stack has more than a quarter of a fringe within 1 nm,
// the mean over the nanometre (17).
color::Spectrum unpolarised(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                            Side side);

}  // namespace shabon::desk
