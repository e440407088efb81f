#include "shabon/optics/reference/stack.h"

#include <algorithm>
#include <cmath>

#include "shabon/optics/reference/film_terms.h"
#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

// What one polarisation knows of a plane: the two tangential fields that every interface leaves as they are, and the
// field F that arrives at the exit for them.
struct Fields {
  Complex F, G;
  double passed = 1;
};

// u of (29) for s and p.
struct Admittances {
  Complex s, p;
};

Admittances admittances(Complex n, Complex n_c) { return {n_c, n_c / (n * n)}; }

// A power of two back to the size of 1; thousands of layers would leave the range of a double.
void keep_in_range(Fields& fields) {
  const double size = norm(fields.F) + norm(fields.G);
  if (size > 0x1p-200 && size < 0x1p200) return;
  if (size == 0) return;
  const int exponent = -std::ilogb(size) / 2;
  const double scale = std::ldexp(1.0, exponent);
  fields.F *= scale;
  fields.G *= scale;
  fields.passed *= scale;
}

// (31): from the layer's far face to its near one.
void cross(Fields& fields, Complex u_sin_beta, Complex sin_beta_over_u, const FilmTerms& layer) {
  constexpr Complex i(0, 1);
  const Complex F = layer.cos_beta * fields.F - i * sin_beta_over_u * fields.G;
  fields.G = layer.cos_beta * fields.G - i * u_sin_beta * fields.F;
  fields.F = F;
  fields.passed *= layer.decay;
  keep_in_range(fields);
}

struct ReflectedTransmitted {
  Complex r, t;
};

// (32), t as a ratio of F.
ReflectedTransmitted amplitudes(Complex u1, const Fields& front) {
  const Complex incident = u1 * front.F + front.G;
  // Only at 90 degrees with nothing between equal media: nothing is reflected, as at every angle below.
  if (incident == 0.0) return {0, front.passed / front.F};
  return {(u1 * front.F - front.G) / incident, 2.0 * u1 * front.passed / incident};
}

}  // namespace

ResolvedStack resolve(const Stack& stack, double wavelength_nm) {
  ResolvedStack resolved;
  resolve(stack, wavelength_nm, resolved);
  return resolved;
}

void resolve(const Stack& stack, double wavelength_nm, ResolvedStack& into) {
  into.n1 = stack.incidence.index(wavelength_nm);
  into.n3 = stack.exit.index(wavelength_nm);
  into.layers.clear();
  into.layers.reserve(stack.layers.size());
  for (const Layer& layer : stack.layers)
    into.layers.push_back({layer.medium.index(wavelength_nm), layer.thickness_nm, layer.coherent});
}

Stack reversed(const Stack& stack) {
  return {stack.exit, {stack.layers.rbegin(), stack.layers.rend()}, stack.incidence};
}

ResolvedStack reversed(const ResolvedStack& stack) {
  return {stack.n3, {stack.layers.rbegin(), stack.layers.rend()}, stack.n1};
}

Amplitudes stack_amplitudes(const ResolvedStack& stack, Incidence incidence, double wavelength_nm) {
  const Admittances exit = admittances(stack.n3, normal_index(stack.n1, incidence, stack.n3));
  Fields s{1, exit.s}, p{1, exit.p};
  for (auto layer = stack.layers.rbegin(); layer != stack.layers.rend(); ++layer) {
    Complex n_c = normal_index(stack.n1, incidence, layer->n);
    if (n_c.imag() < 0) n_c = -n_c;  // behind an absorbing medium; a layer's answer is even in n c
    const FilmTerms terms = film_terms(n_c, layer->thickness_nm, wavelength_nm);
    const Complex n_n = layer->n * layer->n;
    cross(s, n_c * terms.sin_beta, terms.sin_beta_over_n_c, terms);
    cross(p, n_c / n_n * terms.sin_beta, n_n * terms.sin_beta_over_n_c, terms);
  }
  const Admittances first = admittances(stack.n1, stack.n1 * incidence.cos_i);
  const ReflectedTransmitted at_s = amplitudes(first.s, s), at_p = amplitudes(first.p, p);
  return {at_s.r, at_p.r, at_s.t, stack.n1 / stack.n3 * at_p.t};
}

}  // namespace shabon::optics
