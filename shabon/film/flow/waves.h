// Band-limited random fields in space: sums of plane waves with seeded directions and phases. On a sphere they have
// neither seam nor pole, and they are the same whatever the grid.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/math/vec.h"

namespace shabon::film {

class RandomWaves {
 public:
  // Wavelengths from twice `scale` to eight times that; lengths in the unit of the places asked for.
  RandomWaves(std::uint64_t seed, double scale);

  // Mean 0, root mean square 1 over space.
  double value(const math::Vec3d& at) const;
  // A stream function, (73), of which the eddies on a sphere have the root mean square speed 1.
  double stream(const math::Vec3d& at) const;

 private:
  struct Wave {
    math::Vec3d k;
    double phase, per_k;
  };
  std::vector<Wave> waves_;
};

}  // namespace shabon::film
