#include "shabon/optics/reference/layer_fields.h"

#include <cmath>

#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {

using Complex = std::complex<double>;

FieldRatios field_ratios(Complex n, Complex n_c) { return {n_c, n_c / (n * n)}; }

PlaneLayer plane_layer(Complex n1, Incidence incidence, Complex n, double thickness_nm, double wavelength_nm) {
  Complex n_c = normal_index(n1, incidence, n);
  if (n_c.imag() < 0) n_c = -n_c;  // behind an absorbing medium; a layer's answer is even in n c
  return {field_ratios(n, n_c), n * n, film_terms(n_c, thickness_nm, wavelength_nm)};
}

Crossing crossing_s(const PlaneLayer& layer) {
  const FilmTerms& terms = layer.terms;
  return {terms.cos_beta, layer.u.s * terms.sin_beta, terms.sin_beta_over_n_c, terms.decay};
}

Crossing crossing_p(const PlaneLayer& layer) {
  const FilmTerms& terms = layer.terms;
  return {terms.cos_beta, layer.u.p * terms.sin_beta, layer.n_squared * terms.sin_beta_over_n_c, terms.decay};
}

PlaneLayer thick_layer(Complex n1, Incidence incidence, Complex n, double thickness_nm, double wavelength_nm) {
  const Complex n_c = normal_index(n1, incidence, n);
  return {field_ratios(n, n_c), n * n, film_terms(n_c, thickness_nm, wavelength_nm)};
}

double cross(TangentialFields& fields, const Crossing& layer) {
  constexpr Complex i(0, 1);
  const TangentialFields far = fields;
  fields = {layer.cos_beta * far.F - i * layer.sin_beta_over_u * far.G,
            layer.cos_beta * far.G - i * layer.u_sin_beta * far.F};
  const double size = norm(fields.F) + norm(fields.G);
  constexpr double largest = 0x1p200;
  if ((size > 1 / largest && size < largest) || size == 0) return layer.decay;
  const double power_of_two = std::ldexp(1.0, -std::ilogb(size) / 2);
  fields = {fields.F * power_of_two, fields.G * power_of_two};
  return layer.decay * power_of_two;
}

}  // namespace shabon::optics
