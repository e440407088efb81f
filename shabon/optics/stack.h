// A plane stack of layers between two half-spaces, from the side the light comes from.
#pragma once

#include <vector>

#include "shabon/optics/medium.h"

namespace shabon::optics {

inline constexpr int most_layers = 10'000;
inline constexpr double largest_thickness_nm = 1e9;  // one metre

struct Layer {
  Medium medium;
  double thickness_nm = 0;  // 0..largest_thickness_nm
  bool coherent = true;     // false: too thick to interfere, intensities are summed
  friend bool operator==(const Layer&, const Layer&) = default;
};

struct Stack {
  Medium incidence;
  std::vector<Layer> layers;  // at most most_layers
  Medium exit;
  friend bool operator==(const Stack&, const Stack&) = default;
};

}  // namespace shabon::optics
