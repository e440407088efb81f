// What tests of lamp sampling share: chance, means with their errors, integrals over directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/render/base_brightness.h"
#include "shabon/render/lamp_sampling.h"

namespace shabon::render {

using math::Vec3d;

inline constexpr double pi = std::numbers::pi;

class Chance {
 public:
  double operator()() { return uniform_(engine_); }

 private:
  std::mt19937_64 engine_{7};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

inline Vec3d direction_of(double u, double v) {
  return {std::sin(pi * v) * std::sin(2 * pi * (u - 0.5)), std::cos(pi * v),
          -std::sin(pi * v) * std::cos(2 * pi * (u - 0.5))};
}

// The integral of `f` over all directions by the midpoints of a fine grid.
template <class F>
double over_all_directions(int width, int height, const F& f) {
  double sum = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      sum += f(direction_of((column + 0.5) / width, (row + 0.5) / height)) * cell_solid_angle(width, height, row);
  return sum;
}

// The mean of a value that chance gives, and its standard error.
struct Mean {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double value() const { return sum / count; }
  double error() const { return std::sqrt(std::max(0.0, squares / count - value() * value()) / count); }
};

// Five standard errors: some hundred checks fail by chance once in ten thousand runs, and the seed is fixed.
inline constexpr double errors_allowed = 5;

inline color::Spectrum lamp(const char* name) { return color::lamp_radiance(*color::find_illuminant(name)); }

inline scene::Environment with_base(const scene::BaseLight& base) {
  scene::Environment environment;
  environment.channels = {lamp("D65"), lamp("A"), lamp("FL11")};
  environment.base = base;
  return environment;
}

inline const Vec3d normals[] = {{0, 1, 0}, {0.6, 0, 0.8}, {-0.48, -0.6, 0.64}};

}  // namespace shabon::render
