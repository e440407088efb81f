#include "shabon/optics/mixing.h"

namespace shabon::optics {

std::complex<double> lorentz_lorenz_index(std::span<const MixedIndex> parts) {
  std::complex<double> polarisability = 0;
  for (const MixedIndex& part : parts) {
    const std::complex<double> n2 = part.index * part.index;
    polarisability += part.fraction * (n2 - 1.0) / (n2 + 2.0);
  }
  const std::complex<double> index = std::sqrt((1.0 + 2.0 * polarisability) / (1.0 - polarisability));
  return {index.real(), index.imag() < 0 ? 0.0 : index.imag()};  // an imaginary part below 0 is rounding
}

}  // namespace shabon::optics
