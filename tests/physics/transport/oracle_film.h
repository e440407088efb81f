// What a film does to the fields of light, computed in ways the library does not use: the characteristic matrix
// (Abeles 1950; Born and Wolf, section 1.6) for the exact film, the paper's own real form for two beams, a plain loop
// over the internal reflections where phases are lost, and for stacks the reflectances of the walls, put together one
// by one from the far side (Rouard 1937).
#pragma once

#include <complex>
#include <vector>

#include "shabon/optics/interference.h"

namespace shabon::oracle {

using Complex = std::complex<double>;

// Acts on the coherency of light, <E_i conj(E_j)>: ss and pp are multiplied by a power, sp by a complex number.
struct CoherencyFactors {
  double ss = 0, pp = 0;
  Complex sp;
};

struct FilmResponse {
  CoherencyFactors reflected, transmitted;
  bool depolarises = false;  // the paper's model: s and p are averaged at every wall
};

// A layer of a stack.
struct Layer {
  Complex n;
  double thickness_nm;
};

// The exact model for a stack of layers, in the order in which light meets them.
FilmResponse stack_response(double n_outside, const std::vector<Layer>& layers, double cos_i, double wavelength_nm);

// A film of index `n_film` in a lossless medium `n_outside` on both sides; 0 < cos_i <= 1.
FilmResponse film_response(optics::Interference model, double n_outside, Complex n_film, double thickness_nm,
                           double cos_i, double wavelength_nm);

}  // namespace shabon::oracle
