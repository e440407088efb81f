// The same radiance from everywhere.
#pragma once

#include "shabon/math/vec.h"

namespace shabon::scene {

struct ConstantLight {
  int channel = 0;  // index into Environment::channels
  double scale = 1;

  template <class T>
  void add(const math::Vec3<T>&, T* coefficients) const {
    coefficients[channel] = coefficients[channel] + T(scale);
  }
};

}  // namespace shabon::scene
