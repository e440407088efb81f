#include "shabon/film/self_similar.h"

#include <numbers>

namespace shabon::film {

ExponentialThickness prepared(const SelfSimilarThickness& model, double seconds) {
  const double age_s = std::max(0.0, model.age_s + seconds);
  const double unit_s = model.half_time_s / (std::exp2(1 / model.exponent) - 1);
  const double left = std::pow(1 + age_s / unit_s, -model.exponent);  // f
  return {left * std::sqrt(model.top_nm) * std::sqrt(model.bottom_nm), std::log2(model.bottom_nm / model.top_nm) / 2};
}

}  // namespace shabon::film
