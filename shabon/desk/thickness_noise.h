// What is made of fits when the noise of the shares is known, or when it is not: weights and errors (51).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "shabon/desk/thickness_fit.h"

namespace shabon::desk {

// The standard deviation of a share: anything from least to most, one value where they are equal. > 0. Each factor is
// equally likely (log-uniform) above what is usual; below it less so, with the square of the noise.
struct NoiseRange {
  double least = 0, most = 0;
  double usual = 0;
  double widening = 1;  // of the errors: residuals that are alike count as fewer values
};

struct WeighedFit {
  double log_weight = 0;  // of the probability around the minimum, without a factor that all fits share
  double noise = 0;       // geometric mean of the noises that the fit leaves likely
  // Half the widths that hold 68.27 % and 95 %, for each unknown. Nothing where the spectrum does not determine it.
  std::array<std::optional<double>, most_unknowns> standard_error_nm{}, half_95_nm{};
  SmallMatrix covariance{};  // of the thicknesses, for a noise of 1
};

// The integral of the probability over all noises, and for each of them over the thicknesses (Laplace).
WeighedFit weighed(const Fit& fit, const UnknownFilm& film, const FitTarget& target, const NoiseRange& noise);

}  // namespace shabon::desk
