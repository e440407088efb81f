// What a film does to one row of backward light: its Mueller blocks in the plane of incidence (16), for each model of
// interference, in double precision.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"

namespace shabon::optics {

// q0' = a q0 + b q1, q1' = b q0 + a q1, q2' = c q2 + d q3, q3' = -d q2 + c q3.
struct MuellerRow {
  double a = 0, b = 0, c = 0, d = 0;
};

struct FilmRows {
  MuellerRow reflected, transmitted;
};

// airy: exact. two_beam: the paper's clamped wall averages (13), which leave light unpolarised. none: the passes add
// without phase (14), while s and p of one pass keep theirs. Arguments as in airy(), incidence below 90 degrees.
FilmRows film_rows(Interference interference, std::complex<double> n1, std::complex<double> n2, std::complex<double> n3,
                   double thickness_nm, Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
