// A stack of at most one layer under any of the interference models: one call for tables and spectra.
#pragma once

#include "shabon/base/result.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/stack.h"

namespace shabon::optics {

// Errors: more than one layer.
Status check_single_film(const Stack& stack, Interference model);

// R and T of a stack that passed the check, light at `incidence` in stack.incidence, vacuum wavelength in nm. Without a
// layer every model is the bare interface (2)-(5); a layer that is not coherent has no phase in any of them (14).
Powers single_film_powers(const Stack& stack, Interference model, Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
