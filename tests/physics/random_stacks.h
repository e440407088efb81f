// Stacks whose numbers are drawn, for what must hold whatever they are.
#pragma once

#include <complex>
#include <numeric>
#include <vector>

#include "shabon/base/random.h"
#include "shabon/optics/reference/stack.h"

namespace shabon::optics {

enum class Absorption { none, some };

inline std::complex<double> random_index(Pcg32& random, Absorption absorption) {
  // Dielectrics and, if they may absorb, one in three a weak absorber, one in three a metal.
  const double kind = absorption == Absorption::none ? 0 : random.uniform(0, 3);
  if (kind > 2) return {random.uniform(0.05, 3), random.uniform(1, 6)};
  return {random.uniform(1, 2.6), kind > 1 ? random.uniform(0, 0.05) : 0};
}

// 1 to 20 layers of 0 to 400 nm between lossless half-spaces.
inline ResolvedStack random_stack(Pcg32& random, Absorption absorption) {
  ResolvedStack stack;
  stack.n1 = random.uniform(1, 2);
  stack.n3 = random.uniform(1, 2);
  for (int i = 1 + static_cast<int>(random.uniform(0, 20)); i > 0; --i)
    stack.layers.push_back({random_index(random, absorption), random.uniform(0, 400)});
  return stack;
}

// The same with every third layer or so thick and incoherent. A thick layer that absorbs does so weakly: the waves of
// strong ones do not carry their power apart from each other.
inline ResolvedStack random_mixed_stack(Pcg32& random, Absorption absorption) {
  ResolvedStack stack = random_stack(random, absorption);
  for (ResolvedLayer& layer : stack.layers) {
    if (random.uniform() > 0.3) continue;
    const double k = absorption == Absorption::some && random.uniform() < 0.5 ? random.uniform(0, 2e-5) : 0;
    layer = {{random.uniform(1, 2), k}, random.uniform(1e5, 1e6), false};
  }
  return stack;
}

inline double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace shabon::optics
