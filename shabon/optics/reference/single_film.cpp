#include "shabon/optics/reference/single_film.h"

#include <string>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {

Status check_single_film(const Stack& stack, Interference model) {
  if (stack.layers.size() <= 1) return Done{};
  const std::string got = ", got " + std::to_string(stack.layers.size());
  if (model == Interference::two_beam)
    return fail(Failure::content, "two-beam is a model of one layer" + got + "; airy is the exact one");
  return fail(Failure::content, "expected at most one layer" + got);
}

Powers single_film_powers(const Stack& stack, Interference model, Incidence incidence, double wavelength_nm) {
  const auto n1 = stack.incidence.index(wavelength_nm), n3 = stack.exit.index(wavelength_nm);
  if (stack.layers.empty()) return airy(n1, n3, n3, 0, incidence, wavelength_nm);
  const Layer& layer = stack.layers.front();
  const auto n2 = layer.medium.index(wavelength_nm);
  switch (layer.coherent ? model : Interference::none) {
    case Interference::airy:
      return airy(n1, n2, n3, layer.thickness_nm, incidence, wavelength_nm);
    case Interference::two_beam:
      return two_beam(n1, n2, n3, layer.thickness_nm, incidence, wavelength_nm);
    case Interference::none:
      break;
  }
  return without_interference(n1, n2, n3, layer.thickness_nm, incidence, wavelength_nm);
}

}  // namespace shabon::optics
