// What an ellipsometer measures, and the phases of a film or stack.
#pragma once

#include "shabon/optics/reference/powers.h"

namespace shabon::optics {

struct Ellipsometry {
  double psi_deg = 0;    // 0..90
  double delta_deg = 0;  // -90..270, 270 excluded: the two values without absorption, 0 and 180, lie inside
};

// psi and Delta as instruments report them (R. M. A. Azzam and N. M. Bashara, Ellipsometry and Polarized Light, 1977;
// the Nebraska convention), (32): tan(psi) e^(i Delta) = r_p/r_s with r_p = -r_s at normal incidence, for the time
// factor e^(+iwt). This library's factor is e^(-iwt), so the conjugate of its r_p/r_s is taken. Delta is therefore 180
// degrees at normal incidence, 0 at grazing, and between them for a bare metal. Codes that give arg(-r_p/r_s) with
// e^(-iwt), as tmm does, print 180 - Delta.
// Of transmitted light: the same of t_p/t_s. Where both amplitudes are 0 there is nothing to compare: both angles are
// 0.
Ellipsometry ellipsometry(const Amplitudes& amplitudes);
Ellipsometry transmission_ellipsometry(const Amplitudes& amplitudes);

// The phases of the amplitudes for e^(-iwt): a longer way through a lossless layer makes those of t larger. -180..180;
// 0 where the amplitude is 0.
struct Phases {
  double r_s_deg = 0, r_p_deg = 0, t_s_deg = 0, t_p_deg = 0;
};

Phases phases(const Amplitudes& amplitudes);

}  // namespace shabon::optics
