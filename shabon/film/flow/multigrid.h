// Solves (area + L) x = b for the cells, L the sum of coupling times difference over each cell's edges: symmetric,
// positive definite. Conjugate gradients.
#pragma once

#include "shabon/film/flow/metric.h"

namespace shabon::film {

class Multigrid {
 public:
  explicit Multigrid(const Metric& metric);

  // Improves `x` until the residual's length is at most `residual`. The number of iterations; -1 when it takes more
  // than `most`, or is not a number.
  int solve(const Numbers& coupling, const Numbers& b, Numbers& x, double residual, int most);

 private:
  void apply(const Numbers& coupling, const Numbers& x, Numbers& out);

  const Metric& metric_;
  Numbers diagonal_, residual_, direction_, image_, scaled_;
};

}  // namespace shabon::film
