// The starts of a fit: all minima of the residuals on a grid of thicknesses.
#pragma once

#include <vector>

#include "shabon/desk/thickness_fit.h"

namespace shabon::desk {

struct GridMinima {
  std::vector<SmallVector> starts;  // nm, the lowest first
  double step_fringes = 0;          // the largest step of the grid, in fringes (49)
};

// On a grid of `steps_per_fringe`, or coarser where that would take too long. At most `most_starts`.
GridMinima grid_minima(const FilmModel& model, const UnknownFilm& film, const FitTarget& target,
                       const SmallVector& fringes_per_nm, std::size_t most_starts);

}  // namespace shabon::desk
