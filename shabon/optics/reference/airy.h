// A film between two half-spaces with all its internal reflections: the exact answer, in double precision.
//
// For n1 | n2, thickness | n3, any of them absorbing, any angle 0..90 degrees in n1 (Re n1 > 0; no index 0),
// thickness_nm >= 0, wavelength_nm > 0 in vacuum.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/powers.h"

namespace shabon::optics {

// (7), (8).
Amplitudes airy_amplitudes(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3,
                           double thickness_nm, Incidence incidence, double wavelength_nm);

// (9) of these.
Powers airy(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3, double thickness_nm,
            Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
