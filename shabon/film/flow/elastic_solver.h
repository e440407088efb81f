// Solves (area + L) x = b for the cells, L the sum of coupling times difference over each cell's edges: symmetric,
// positive definite. Conjugate gradients; where L is large against the area, with a multigrid preconditioner.
#pragma once

#include "shabon/film/flow/metric.h"
#include "shabon/film/flow/multigrid.h"

namespace shabon::film {

class ElasticSolver {
 public:
  explicit ElasticSolver(const Metric& metric);

  // Improves `x` until the residual's length is at most `residual`. The number of iterations; -1 when it takes more
  // than `most`, or is not a number.
  int solve(const Numbers& coupling, const Numbers& b, Numbers& x, double residual, int most);

 private:
  void multiply(const Numbers& coupling, const Numbers& x, Numbers& out);
  void set_diagonal(const Numbers& coupling);
  bool is_stiff(const Numbers& coupling) const;
  void precondition(bool stiff);

  const Metric& metric_;
  Multigrid multigrid_;
  Numbers per_diagonal_, residual_, direction_, image_, scaled_;
};

}  // namespace shabon::film
