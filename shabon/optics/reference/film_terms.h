// The trigonometry of one layer, in the form that (7), (8) and (31) are computed in.
#pragma once

#include <complex>

namespace shabon::optics {

// All three times e^(-Im beta), so that an opaque layer does not overflow.
struct FilmTerms {
  std::complex<double> cos_beta;
  std::complex<double> sin_beta;
  std::complex<double> sin_beta_over_n_c;  // finite also at the critical angle, where both vanish
  double decay = 1;                        // e^(-Im beta)
};

// For a layer with normal_index() `n_c`, thickness_nm >= 0, wavelength_nm > 0. Of the two roots +-n_c, which make the
// same layer, the one with Im >= 0.
FilmTerms film_terms(std::complex<double> n_c, double thickness_nm, double wavelength_nm);

}  // namespace shabon::optics
