// Two spectra mixed by height: spectrum(y) = mix(down, up, (1 + y)/2).
#pragma once

#include "shabon/math/vec.h"

namespace shabon::scene {

struct GradientLight {
  int up_channel = 0, down_channel = 0;
  double up_scale = 1, down_scale = 0;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    const T share = (T(1) + direction.y) * T(0.5);
    coefficients[up_channel] = coefficients[up_channel] + share * T(up_scale);
    coefficients[down_channel] = coefficients[down_channel] + (T(1) - share) * T(down_scale);
  }
};

}  // namespace shabon::scene
