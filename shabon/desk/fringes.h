// How fine the fringes of a film are over wavelength, against the sums of 1 nm (17), and where to look at fringes that
// they do not resolve. Inside the room only.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::desk {

// With more fringes than this within 1 nm one wavelength no longer stands for its nanometre, and the mean over it is
// taken, see (17). Half of what would turn a fringe over from one value to the next.
inline constexpr double most_fringes_per_nm = 0.25;

// Fringes of the round trips through the coherent layers, 2 Re(n cos) d/wavelength^2 for each, with the indices held. A
// layer that lets nothing through makes none.
struct Fringes {
  double all_per_nm = 0;       // of all layers together
  double thickest_per_nm = 0;  // of the layer that has the most
  std::size_t thickest = 0;    // that layer, an index; 0 where no layer has any
};

// Of the whole stack, or of all but one layer.
Fringes fringes(const optics::ResolvedStack& stack, optics::Incidence incidence, double wavelength_nm,
                std::optional<std::size_t> without = {});

// Fringes of one layer from one end of a nanometre to the other, for each nm of its thickness. With dispersion, so that
// the stretches of neighbouring nanometres join.
double fringes_across_per_nm(const optics::Stack& stack, std::size_t layer, optics::Incidence incidence,
                             double middle_nm);

// Whether a stack can have too many: false for all films thin enough to save the question.
bool may_have_fine_fringes(const optics::Stack& stack, std::optional<std::size_t> without = {});

// Where to look within a nanometre, as offsets of -0.5..0.5 nm from its middle: {0} when that is enough. Evenly spaced
// while that follows every fringe; otherwise a lattice that covers the nanometre and the phase of the thickest layer
// evenly, both at once (N. M. Korobov 1959; with Fibonacci numbers S. K. Zaremba 1966).
std::vector<double> looks_within_nm(const Fringes& fringes);

}  // namespace shabon::desk
