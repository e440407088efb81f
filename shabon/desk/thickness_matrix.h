// Symmetric matrices of at most most_unknowns rows: the normal equations of a fit.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "shabon/desk/thickness_model.h"

namespace shabon::desk {

using SmallVector = std::array<double, most_unknowns>;
using SmallMatrix = std::array<SmallVector, most_unknowns>;  // the first `size` rows and columns count

// The lower triangle L of m = L L^T; nothing when m is not positive definite to rounding.
inline std::optional<SmallMatrix> cholesky(const SmallMatrix& m, std::size_t size) {
  constexpr double rounding = 1e-14;
  SmallMatrix lower{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      if (i != j) {
        lower[i][j] = sum / lower[j][j];
      } else {
        if (!(sum > rounding * m[i][i])) return {};
        lower[i][i] = std::sqrt(sum);
      }
    }
  }
  return lower;
}

// m x = v for m = L L^T.
inline SmallVector solve(const SmallMatrix& lower, SmallVector v, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) v[i] -= lower[i][k] * v[k];
    v[i] /= lower[i][i];
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t k = i + 1; k < size; ++k) v[i] -= lower[k][i] * v[k];
    v[i] /= lower[i][i];
  }
  return v;
}

inline SmallMatrix inverse(const SmallMatrix& lower, std::size_t size) {
  SmallMatrix result{};
  for (std::size_t j = 0; j < size; ++j) {
    SmallVector unit{};
    unit[j] = 1;
    const SmallVector column = solve(lower, unit, size);
    for (std::size_t i = 0; i < size; ++i) result[i][j] = column[i];
  }
  return result;
}

// ln det m for m = L L^T.
inline double log_determinant(const SmallMatrix& lower, std::size_t size) {
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += 2 * std::log(lower[i][i]);
  return sum;
}

}  // namespace shabon::desk
