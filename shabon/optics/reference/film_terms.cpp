#include "shabon/optics/reference/film_terms.h"

#include <cmath>
#include <numbers>

#include "shabon/optics/reference/phase.h"

namespace shabon::optics {

FilmTerms film_terms(std::complex<double> n_c, double thickness_nm, double wavelength_nm) {
  const Passage film = passage(n_c, thickness_nm, wavelength_nm);
  // e^(-y) cosh y and e^(-y) sinh y with y = Im beta.
  const double scaled_cosh = (1 + std::exp(-2 * film.loss)) / 2;
  const double scaled_sinh = -std::expm1(-2 * film.loss) / 2;
  const double cosine = std::cos(film.phase_rad), sine = std::sin(film.phase_rad);
  FilmTerms terms;
  terms.cos_beta = {cosine * scaled_cosh, -sine * scaled_sinh};
  terms.sin_beta = {sine * scaled_cosh, cosine * scaled_sinh};
  terms.sin_beta_over_n_c =
      n_c == 0.0 ? std::complex<double>(2 * std::numbers::pi * thickness_nm / wavelength_nm) : terms.sin_beta / n_c;
  terms.decay = std::exp(-film.loss);
  return terms;
}

}  // namespace shabon::optics
