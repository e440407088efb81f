// What a film does at the facets of a rough boundary, at the nodes of their cosines, for rest_table.cpp.
#pragma once

#include <vector>

#include "shabon/render/kernel/scattering/rest_table.h"
#include "shabon/render/microfacet.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

// Of the hat functions over the facets' cosines each one's share of a diffuse field.
inline std::vector<float> facet_weights(const FacetCosines& cosines) {
  std::vector<float> weights(facet_nodes);
  for (int k = 0; k + 1 < facet_nodes; ++k) {
    const double a = cosines.at(k), b = cosines.at(k + 1);
    weights[static_cast<std::size_t>(k)] += static_cast<float>((b - a) * (2 * a + b) / 3);
    weights[static_cast<std::size_t>(k) + 1] += static_cast<float>((b - a) * (a + 2 * b) / 3);
  }
  return weights;
}

inline Lanes weighted(const std::vector<float>& weights, const Lanes* values) {
  Lanes sum(0.0f);
  for (std::size_t k = 0; k < weights.size(); ++k) sum += values[k] * Lanes(weights[k]);
  return sum;
}

// What the facets do at the nodes of their cosines, and its mean over a diffuse field.
struct FacetPowers {
  Lanes R[facet_nodes], T[facet_nodes];
  Lanes R_mean{0.0f}, T_mean{0.0f};
};

// The same nodes for all wavelengths.
inline FacetPowers powers_at(const RestTable::Side& side, const FacetCosines& cosines, std::size_t comb,
                             double thickness_nm) {
  FacetPowers result;
  for (int k = 0; k < facet_nodes; ++k) {
    const BoundaryPowers both = side.powers(comb, cosines.at(k), thickness_nm);
    result.R[k] = both.reflected, result.T[k] = both.transmitted;
  }
  const std::vector<float> over_facets = facet_weights(cosines);
  result.R_mean = weighted(over_facets, result.R), result.T_mean = weighted(over_facets, result.T);
  return result;
}

// Each wavelength at the nodes of its own critical angle.
inline FacetPowers powers_at_own(const RestTable::Side& side, std::size_t comb, double thickness_nm) {
  alignas(64) float R[facet_nodes][lane_count], T[facet_nodes][lane_count], means[2][lane_count];
  for (int i = 0; i < lane_count; ++i) {
    const FacetPowers own = powers_at(side, FacetCosines(side.each_near_over_far[comb][i]), comb, thickness_nm);
    for (int k = 0; k < facet_nodes; ++k) R[k][i] = own.R[k][i], T[k][i] = own.T[k][i];
    means[0][i] = own.R_mean[i], means[1][i] = own.T_mean[i];
  }
  FacetPowers result;
  for (int k = 0; k < facet_nodes; ++k) result.R[k] = Lanes::load(R[k]), result.T[k] = Lanes::load(T[k]);
  result.R_mean = Lanes::load(means[0]), result.T_mean = Lanes::load(means[1]);
  return result;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
