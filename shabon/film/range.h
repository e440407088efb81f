#pragma once

#include "shabon/base/field.h"

namespace shabon::film {

// What a thickness may be. At the upper end, 1 mm, the fringes of a water film are 0.1 nm apart (lambda^2 / (2 n d)),
// ten times finer than the 1 nm tables of observers and lamps: beyond it a film has no colour left to compute.
inline constexpr Range thickness_range_nm{.low = 0, .high = 1e6};

}  // namespace shabon::film
