// The film of the 1989 paper (Yokoi, Suzuki, Toriwaki), its slips corrected: the beam reflected at the first wall and
// the one reflected once at the second interfere, the transmitted light does not. Approximate: R and T need not sum
// to 1.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/powers.h"

namespace shabon::optics {

// (11), (12): r = r12 + t12 t21 r23 e^(2i beta), t = t12 t23 e^(i beta). Unclamped: R exceeds 1 near grazing incidence.
// Arguments as in airy().
Powers two_beam(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3, double thickness_nm,
                Incidence incidence, double wavelength_nm);

// The paper's shares at a wall that light meets: f_h of the reflected, f_t of the transmitted light.
struct WallAverages {
  double f_h = 0, f_t = 0;
};

// (13): f_h = (min(1, R_s) + min(1, R_p))/2, f_t = (T_s + T_p)/2.
WallAverages wall_averages(const Powers& powers);

}  // namespace shabon::optics
