// A film too thick to interfere: the intensities of all internal reflections, summed without phase (14).
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/powers.h"

namespace shabon::optics {

// (14): with the walls' powers R12, T12, ... by (9) and one passage through the film A = e^(-2 Im beta),
//   R = R12 + T12 T21 R23 A^2 / (1 - R21 R23 A^2),   T = T12 T23 A / (1 - R21 R23 A^2).
// For a free lossless film these are 2 rho/(1 + rho) and 1 - R. Where no power can travel in the film (beyond its
// critical angle), or where a wave decays within a wavelength (a metal), the walls' powers do not add up: when the
// first medium is lossless, the sums are held to R <= 1 and R + T <= 1, which makes R = 1 beyond the critical angle.
// Arguments as in airy().
Powers without_interference(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3,
                            double thickness_nm, Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
