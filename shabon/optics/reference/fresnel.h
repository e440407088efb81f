// One interface between two half-spaces, in double precision: Snell (1) and Fresnel (2)-(5), complex throughout.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"

namespace shabon::optics {

// Ratios of electric fields. r_p has the sign that makes r_p = -r_s at normal incidence.
struct InterfaceAmplitudes {
  std::complex<double> r_s, r_p, t_s, t_p;
};

// The root of `square` that belongs to a wave going forward: it decays or, without absorption, travels into the medium.
std::complex<double> forward_root(std::complex<double> square);

// (1): n c in a medium of index n behind a first medium n1, c the complex cosine of its angle of refraction. Exactly
// n1 cos_i where n = n1; without absorption it is real, or past the critical angle purely imaginary and positive.
std::complex<double> normal_index(std::complex<double> n1, Incidence incidence, std::complex<double> n);

// (1): that cosine itself.
std::complex<double> refracted_cosine(std::complex<double> n1, Incidence incidence, std::complex<double> n);

// (2)-(5) for light that goes from n1 at cosine c1 to n2 at cosine c2. Where both cosines are 0 the limit of equal
// media holds: nothing is reflected.
InterfaceAmplitudes fresnel(std::complex<double> n1, std::complex<double> c1, std::complex<double> n2,
                            std::complex<double> c2);

}  // namespace shabon::optics
