#include "shabon/optics/reference/stack_model.h"

#include <algorithm>
#include <string>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {

Status check_model(const Stack& stack, Interference model) {
  if (model == Interference::airy || stack.layers.size() <= 1) return Done{};
  return fail(Failure::content, std::string(name_of(model)) + " is a model of one layer, got " +
                                    std::to_string(stack.layers.size()) + "; use airy, which is exact for any stack");
}

Powers model_powers(const Stack& stack, Interference model, Incidence incidence, double wavelength_nm) {
  return model_powers(resolve(stack, wavelength_nm), model, incidence, wavelength_nm);
}

Powers model_powers(const ResolvedStack& stack, Interference model, Incidence incidence, double wavelength_nm) {
  const auto n1 = stack.n1, n3 = stack.n3;
  if (stack.layers.empty()) return airy(n1, n3, n3, 0, incidence, wavelength_nm);
  if (stack.layers.size() > 1) {
    const bool coherent = std::all_of(stack.layers.begin(), stack.layers.end(), [](auto& at) { return at.coherent; });
    return coherent ? powers_of(stack_amplitudes(stack, incidence, wavelength_nm), n1, n3, incidence)
                    : stack_powers(stack, incidence, wavelength_nm).powers;
  }
  const ResolvedLayer& layer = stack.layers.front();
  switch (layer.coherent ? model : Interference::none) {
    case Interference::airy:
      return airy(n1, layer.n, n3, layer.thickness_nm, incidence, wavelength_nm);
    case Interference::two_beam:
      return two_beam(n1, layer.n, n3, layer.thickness_nm, incidence, wavelength_nm);
    case Interference::none:
      break;
  }
  return without_interference(n1, layer.n, n3, layer.thickness_nm, incidence, wavelength_nm);
}

}  // namespace shabon::optics
