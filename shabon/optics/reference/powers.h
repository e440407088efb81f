// From amplitudes to powers (9).
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"

namespace shabon::optics {

// Amplitudes of a whole film or stack, as ratios of electric fields: r at the first interface, t at the last.
struct Amplitudes {
  std::complex<double> r_s, r_p, t_s, t_p;
};

// Shares of the incident power, per polarisation.
struct Powers {
  double R_s = 0, R_p = 0, T_s = 0, T_p = 0;
};

// (9): R = |r|^2, T_s = |t_s|^2 Re(n3 c3)/Re(n1 c1), T_p = |t_p|^2 Re(n3 conj(c3))/Re(n1 conj(c1)), for light from n1
// into n3. At 90 degrees the limit is taken.
Powers powers_of(const Amplitudes& amplitudes, std::complex<double> n1, std::complex<double> n3, Incidence incidence);

}  // namespace shabon::optics
