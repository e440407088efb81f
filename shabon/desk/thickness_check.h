// What a question about thicknesses must have.
#pragma once

#include "shabon/base/result.h"
#include "shabon/desk/thickness_model.h"

namespace shabon::desk {

// Failure::content: no unknowns or more than `most`, layers that are none or belong to two unknowns, a range that does
// not rise or leaves 0..largest_thickness_nm.
Status check_unknowns(const UnknownFilm& film, std::size_t most);

}  // namespace shabon::desk
