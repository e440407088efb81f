// A stack under any of the interference models: one call for tables and spectra.
#pragma once

#include "shabon/base/result.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/stack.h"

namespace shabon::optics {

// Airy takes any stack. Errors: more than one layer in any other model; the message names airy.
Status check_model(const Stack& stack, Interference model);

// R and T of a stack that passed the check, light at `incidence` in stack.incidence, vacuum wavelength in nm. Without a
// layer every model is the bare interface (2)-(5); a single layer that is not coherent has no phase in any of them
// (14). For a stack that is resolved already, allocates nothing while all layers are coherent.
Powers model_powers(const Stack& stack, Interference model, Incidence incidence, double wavelength_nm);
Powers model_powers(const ResolvedStack& stack, Interference model, Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
