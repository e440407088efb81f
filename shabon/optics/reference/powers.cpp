#include "shabon/optics/reference/powers.h"

#include "shabon/optics/reference/fresnel.h"

namespace shabon::optics {

Powers powers_of(const Amplitudes& a, std::complex<double> n1, std::complex<double> n3, Incidence incidence) {
  // At 90 degrees either nothing enters (t = 0) or the whole film is made of the first medium (|t| = 1).
  double ratio_s = 1, ratio_p = 1;
  if (incidence.cos_i > 0) {
    const std::complex<double> c1 = incidence.cos_i, c3 = refracted_cosine(n1, incidence, n3);
    ratio_s = real(n3 * c3) / real(n1 * c1);
    ratio_p = real(n3 * conj(c3)) / real(n1 * conj(c1));
  }
  return {norm(a.r_s), norm(a.r_p), norm(a.t_s) * ratio_s, norm(a.t_p) * ratio_p};
}

}  // namespace shabon::optics
