// Films whose two walls are given one reflectance each, without polarisation, and then to the Airy sum.
#pragma once

#include <complex>

#include "shabon/optics/incidence.h"

namespace shabon::desk {

struct WallShares {
  double reflected = 0, transmitted = 0;
};

// One amplitude for both polarisations of light that goes from n_a into n_b. `n1` is the medium in which the incidence
// is measured.
using WallAmplitude = std::complex<double> (*)(std::complex<double> n1, optics::Incidence incidence,
                                               std::complex<double> n_a, std::complex<double> n_b);

// The amplitude at normal incidence, grown so that its square follows Schlick's polynomial F0 + (1 - F0)(1 - c)^5, with
// the cosine on the side of the lower index; total reflection keeps |r| = 1. C. Schlick, "An inexpensive BRDF model for
// physically-based rendering", Computer Graphics Forum 13 (3), 233-246 (1994).
std::complex<double> schlick_amplitude(std::complex<double> n1, optics::Incidence incidence, std::complex<double> n_a,
                                       std::complex<double> n_b);

// The root of the mean of R_s and R_p (2), (3), with the phase of r_s.
std::complex<double> average_amplitude(std::complex<double> n1, optics::Incidence incidence, std::complex<double> n_a,
                                       std::complex<double> n_b);

// A film of two such walls at one vacuum wavelength: the Airy sum (7), (8) with t t' = 1 - r^2 (Stokes), and what a
// wall does not reflect goes through it. Exact at normal incidence where nothing absorbs.
class FilmOfWalls {
 public:
  FilmOfWalls(WallAmplitude amplitude, std::complex<double> n1, std::complex<double> n2, std::complex<double> n3,
              optics::Incidence incidence, double wavelength_nm);

  WallShares at(double thickness_nm) const;

  // The mean over a nanometre within which the wavelength passes so many fringes (17), by the same rule as the exact
  // colour: one wavelength stands for it while they are few.
  WallShares mean(double thickness_nm, double fringes) const;

 private:
  WallShares shares(std::complex<double> once, std::complex<double> twice) const;

  std::complex<double> r12_, r23_, normal_index_;
  double wavelength_nm_;
};

}  // namespace shabon::desk
