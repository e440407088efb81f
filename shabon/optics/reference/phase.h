// One passage through a film: the phase (6) and the loss.
#pragma once

#include <complex>

namespace shabon::optics {

struct Passage {
  double phase_rad = 0;  // Re beta, reduced to -pi..pi
  double loss = 0;       // Im beta >= 0: amplitudes fall by e^(-loss)

  std::complex<double> factor() const;  // e^(i beta)
};

// (6): beta = 2 pi n d c/lambda, with `normal_index` = n c of the film. The cycles are reduced before they become an
// angle, so that a thick film loses no digits to sine and cosine. A film amplifies nothing: loss is never negative.
Passage passage(std::complex<double> normal_index, double thickness_nm, double wavelength_nm);

}  // namespace shabon::optics
