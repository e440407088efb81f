#include "shabon/film/equilibrium.h"

#include <numbers>

namespace shabon::film {

double squeeze_of(const EquilibriumThickness& model) {
  if (model.squeeze) return *model.squeeze;
  // The bottom would be exp(1000) times as thick as the top: numbers end there, films long before.
  constexpr double most = 500;
  const double weight_n_m =
      model.density_kg_m3 * standard_gravity_m_s2 * model.radius_m * model.mean_nm * 1e-9;  // of a film's width
  return std::min(weight_n_m / model.elasticity_n_m, most);
}

ExponentialThickness prepared(const EquilibriumThickness& model, double /*seconds*/) {
  const double a = squeeze_of(model);
  const double share = a < 1e-4 ? 1 - a * a / 6 : a / std::sinh(a);
  return {model.mean_nm * share, a / std::numbers::ln2};
}

}  // namespace shabon::film
