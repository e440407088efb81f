// Carries the film's thickness with the film's surfactant, (80)-(84) in docs/living-film.md: the ratio of the two is
// taken at the middle of the area that crosses an edge (Miura 2007) and limited (Zalesak 1979), so that it keeps within
// the bounds of its neighbours and a uniform ratio stays uniform.
#pragma once

#include "shabon/film/flow/metric.h"

namespace shabon::film {

class Transport {
 public:
  explicit Transport(const Metric& metric);

  // What crosses the edges, away from their owners, in one step.
  struct Crossing {
    const Numbers& surfactant;  // amount: per area, times m^2
    const Numbers& along;       // m/s, at the edges
    const Numbers& left;        // m/s, across (metric.h)
    double step_s;
  };
  // `before` and `after` are the surfactant per area of the cells, positive; thickness before to thickness after.
  // Conserves the sum of thickness times area to rounding. Valid while no cell loses all that it holds in a step.
  void move(const Crossing& crossing, const Numbers& before, const Numbers& after, const Numbers& thickness,
            Numbers& moved);

 private:
  void find_slopes();
  void flux_over_edges(const Crossing& crossing);
  void find_bounds(const Numbers& after, const Numbers& thickness);
  void limit(const Numbers& after);
  void finish(const Numbers& thickness, Numbers& moved) const;

  const Metric& metric_;
  Padded<float> weight_x_, weight_y_;            // six a cell: least-squares slope of a linear function, 1/m
  Padded<float> own_x_, own_y_, far_x_, far_y_;  // of edges: their direction in the frames of owner and neighbour
  Padded<float> aside_;  // of edges: their middle, to the left of the line between the centres, m
  Numbers ratio_, slope_x_, slope_y_, low_, anti_, settled_, lowest_, highest_, gain_, loss_;
};

}  // namespace shabon::film
