// Least squares from one start: the nearest thicknesses at which a film reflects or transmits what was measured (50).
#pragma once

#include <span>
#include <vector>

#include "shabon/desk/thickness_matrix.h"
#include "shabon/desk/thickness_model.h"

namespace shabon::desk {

struct FitTarget {
  std::span<const double> measured;  // as FilmModel lays them out
  bool free_scale = false;           // measured = scale times computed, with one unknown scale for all values
};

// The sum of squared differences at the model's thicknesses; `computed` is its result there. With a free scale it is
// the smallest of any scale >= 0, which is stored.
double sum_of_squares(const FitTarget& target, std::span<const double> computed, double& scale);

struct Fit {
  SmallVector thickness_nm{};
  double squares = 0;             // sum of squared differences
  double scale = 1;               // 1 unless it is free
  SmallMatrix curvature{};        // J^T J, of the differences, per nm^2; with a free scale what remains beside it
  std::vector<double> residuals;  // computed minus measured
};

// Levenberg and Marquardt, within the unknowns' ranges. Deterministic. `start` within the ranges.
Fit fitted(FilmModel& model, const UnknownFilm& film, const FitTarget& target, const SmallVector& start,
           const SmallVector& longest_step_nm);

}  // namespace shabon::desk
