// With the walls' amplitudes r12 = (u1 - u2)/(u1 + u2), t12 = 2 u1/(u1 + u2) and e^(i beta) = cos beta + i sin beta,
//   (7)  r = (r12 + r23 e^(2i beta)) / (1 + r12 r23 e^(2i beta))
//          = ((u1 - u3) cos beta - i (u1 u3/u2 - u2) sin beta) / D
//   (8)  t = t12 t23 e^(i beta) / (1 + r12 r23 e^(2i beta)) = 2 u1 / D
//        D = (u1 + u3) cos beta - i (u1 u3/u2 + u2) sin beta
// where u = n c for s and u = c/n for p; t_p is n1/n3 times that, a ratio of electric fields. In this form nothing
// cancels at grazing incidence, and zero thickness, the critical angle and equal media need no case of their own.

#include "shabon/optics/reference/airy.h"

#include "shabon/optics/reference/film_terms.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

struct FilmAmplitudes {
  Complex r, t;
};

// (7), (8) for one polarisation.
FilmAmplitudes film_amplitudes(Complex u1, Complex u3, Complex sin_beta_over_u2, Complex u2_sin_beta,
                               const FilmTerms& film) {
  constexpr Complex i(0, 1);
  const Complex denominator = (u1 + u3) * film.cos_beta - i * (u1 * u3 * sin_beta_over_u2 + u2_sin_beta);
  // Only at 90 degrees with nothing between equal media: nothing is reflected, as at every angle below.
  if (denominator == 0.0) return {0, film.decay / film.cos_beta};
  return {((u1 - u3) * film.cos_beta - i * (u1 * u3 * sin_beta_over_u2 - u2_sin_beta)) / denominator,
          2.0 * u1 * film.decay / denominator};
}

}  // namespace

Amplitudes airy_amplitudes(Complex n1, Complex n2, Complex n3, double thickness_nm, Incidence incidence,
                           double wavelength_nm) {
  const Complex n1_c1 = n1 * incidence.cos_i;
  const Complex n3_c3 = normal_index(n1, incidence, n3);
  Complex n2_c2 = normal_index(n1, incidence, n2);
  if (n2_c2.imag() < 0) n2_c2 = -n2_c2;  // behind an absorbing medium; the film's answer is even in n2 c2
  const FilmTerms film = film_terms(n2_c2, thickness_nm, wavelength_nm);

  const FilmAmplitudes s = film_amplitudes(n1_c1, n3_c3, film.sin_beta_over_n_c, n2_c2 * film.sin_beta, film);
  const FilmAmplitudes p = film_amplitudes(n1_c1 / (n1 * n1), n3_c3 / (n3 * n3), n2 * n2 * film.sin_beta_over_n_c,
                                           n2_c2 / (n2 * n2) * film.sin_beta, film);
  return {s.r, p.r, s.t, n1 / n3 * p.t};
}

Powers airy(Complex n1, Complex n2, Complex n3, double thickness_nm, Incidence incidence, double wavelength_nm) {
  return powers_of(airy_amplitudes(n1, n2, n3, thickness_nm, incidence, wavelength_nm), n1, n3, incidence);
}

}  // namespace shabon::optics
