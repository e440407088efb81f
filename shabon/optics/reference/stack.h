// A plane stack of any number of layers, exact and in double precision: (29)-(36).
//
// For any media with Re n1 > 0 (no index 0), any angle 0..90 degrees in the first one, at most most_layers layers of
// 0..largest_thickness_nm, vacuum wavelength > 0 nm. Opaque and evanescent layers do not overflow; zero thickness,
// grazing incidence (R = 1), the critical angle and equal media are limits like any other angle or thickness. An
// amplitude or power below 1e-308 is 0.
//
// Signs as everywhere: time factor e^(-iwt), n + ik with k > 0 absorbs; r_p = (n2 c1 - n1 c2)/(n2 c1 + n1 c2), so that
// r_p = -r_s at normal incidence; r is the reflected over the incident electric field at the first interface, t the
// transmitted field at the last interface over the incident field at the first.
#pragma once

#include <complex>
#include <vector>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/stack.h"

namespace shabon::optics {

struct ResolvedLayer {
  std::complex<double> n;
  double thickness_nm = 0;
  bool coherent = true;
};

// A stack at one wavelength: numbers in place of media.
struct ResolvedStack {
  std::complex<double> n1 = 1;
  std::vector<ResolvedLayer> layers;
  std::complex<double> n3 = 1;
};

ResolvedStack resolve(const Stack& stack, double wavelength_nm);

// The same into a stack that is used again and again, so that a loop over wavelengths allocates once.
void resolve(const Stack& stack, double wavelength_nm, ResolvedStack& into);

// The stack as light from the other side meets it. The angle is then measured in what was the exit medium.
Stack reversed(const Stack& stack);
ResolvedStack reversed(const ResolvedStack& stack);

// (29)-(32), all layers taken as coherent. Allocates nothing.
Amplitudes stack_amplitudes(const ResolvedStack& stack, Incidence incidence, double wavelength_nm);
Amplitudes stack_amplitudes(const Stack& stack, Incidence incidence, double wavelength_nm);

struct StackPowers {
  Powers powers;
  std::vector<double> A_s, A_p;  // per layer, from the incidence side: the share of the incident power it absorbs
};

// (33)-(36): coherent layers and incoherent ones, whose reflections add as intensities. A lossless layer absorbs
// exactly 0. With a lossless first medium R + T + all A = 1; if it absorbs, incident and reflected light also exchange
// energy.
StackPowers stack_powers(const ResolvedStack& stack, Incidence incidence, double wavelength_nm);
StackPowers stack_powers(const Stack& stack, Incidence incidence, double wavelength_nm);

}  // namespace shabon::optics
