#include "shabon/film/thickness_field.h"

#include <cmath>
#include <numbers>

namespace shabon::film {

ThicknessField at_time(const ThicknessModel& model, double seconds) {
  return std::visit([&](const auto& chosen) { return ThicknessField(detail::ready(chosen, seconds)); }, model);
}

// At the points of a Fibonacci lattice, which fills the sphere evenly.
double mean_thickness_nm(const ThicknessField& field) {
  constexpr int points = 4096;
  constexpr double golden_turn = 2 * std::numbers::pi * (2 - std::numbers::phi);
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double y = 1 - (2 * i + 1.0) / points, r = std::sqrt((1 - y) * (1 + y)), phi = golden_turn * i;
    sum += thickness_nm(field, math::Vec3d{r * std::cos(phi), y, r * std::sin(phi)});
  }
  return sum / points;
}

}  // namespace shabon::film
