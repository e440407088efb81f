// The two tangential fields that every interface leaves as they are, carried backwards through one layer after the
// other (29)-(31). What stack_amplitudes() and stack_powers() are made of.
//
// One polarisation at a time: F is E_y for s and H_y for p, G is H_x or E_x, and G = u F in a wave that goes forward,
// with u = n c for s and c/n for p.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"
#include "shabon/optics/reference/film_terms.h"

namespace shabon::optics {

// (29) of one half-space or layer.
struct FieldRatios {
  std::complex<double> s, p;
};

FieldRatios field_ratios(std::complex<double> n, std::complex<double> n_c);

// A layer at one wavelength and angle. Its `u` has the sign of a wave that decays forwards; crossing it, both signs
// give the same.
struct PlaneLayer {
  FieldRatios u;
  std::complex<double> n_squared;
  FilmTerms terms;
};

PlaneLayer plane_layer(std::complex<double> n1, Incidence incidence, std::complex<double> n, double thickness_nm,
                       double wavelength_nm);

// The same for an incoherent layer, which is never crossed by fields: `u` is that of the wave that goes forward, and
// the decay is 1 where behind an absorbing medium that wave would grow.
PlaneLayer thick_layer(std::complex<double> n1, Incidence incidence, std::complex<double> n, double thickness_nm,
                       double wavelength_nm);

// What (31) needs to know of a layer, for one polarisation.
struct Crossing {
  std::complex<double> cos_beta, u_sin_beta, sin_beta_over_u;
  double decay;
};

Crossing crossing_s(const PlaneLayer& layer);
Crossing crossing_p(const PlaneLayer& layer);

struct TangentialFields {
  std::complex<double> F, G;

  double flux() const { return real(F * conj(G)); }  // (33)
};

// (31): replaces the fields at a layer's far face by those at its near face, times the returned factor, which keeps
// them in the range of a double however many or opaque the layers are: e^(-Im beta), now and then times a power of two.
double cross(TangentialFields& fields, const Crossing& layer);

}  // namespace shabon::optics
