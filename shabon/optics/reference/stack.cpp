#include "shabon/optics/reference/stack.h"

#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/layer_fields.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

struct ReflectedTransmitted {
  Complex r, t;
};

// (32), t as a ratio of F. `factor` is the product of what cross() returned.
ReflectedTransmitted amplitudes(Complex u1, const TangentialFields& front, double factor) {
  const Complex incident = u1 * front.F + front.G;
  // Only at 90 degrees with nothing between equal media: nothing is reflected, as at every angle below.
  if (incident == 0.0) return {0, factor / front.F};
  return {(u1 * front.F - front.G) / incident, 2.0 * u1 * factor / incident};
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
  const FieldRatios u1 = field_ratios(stack.n1, stack.n1 * incidence.cos_i);
  const FieldRatios u3 = field_ratios(stack.n3, normal_index(stack.n1, incidence, stack.n3));
  TangentialFields s{1, u3.s}, p{1, u3.p};
  double factor_s = 1, factor_p = 1;
  for (auto layer = stack.layers.rbegin(); layer != stack.layers.rend(); ++layer) {
    const PlaneLayer at = plane_layer(stack.n1, incidence, layer->n, layer->thickness_nm, wavelength_nm);
    factor_s *= cross(s, crossing_s(at));
    factor_p *= cross(p, crossing_p(at));
  }
  const ReflectedTransmitted at_s = amplitudes(u1.s, s, factor_s), at_p = amplitudes(u1.p, p, factor_p);
  return {at_s.r, at_p.r, at_s.t, stack.n1 / stack.n3 * at_p.t};  // from magnetic to electric fields for p
}

Amplitudes stack_amplitudes(const Stack& stack, Incidence incidence, double wavelength_nm) {
  return stack_amplitudes(resolve(stack, wavelength_nm), incidence, wavelength_nm);
}

}  // namespace shabon::optics
