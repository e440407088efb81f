#include "shabon/optics/reference/two_beam.h"

#include <algorithm>

#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/phase.h"

namespace shabon::optics {

Powers two_beam(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3, double thickness_nm,
                Incidence incidence, double wavelength_nm) {
  const std::complex<double> c1 = incidence.cos_i;
  const std::complex<double> c2 = refracted_cosine(n1, incidence, n2);
  const std::complex<double> c3 = refracted_cosine(n1, incidence, n3);
  const InterfaceAmplitudes wall12 = fresnel(n1, c1, n2, c2);
  const InterfaceAmplitudes wall21 = fresnel(n2, c2, n1, c1);
  const InterfaceAmplitudes wall23 = fresnel(n2, c2, n3, c3);
  const std::complex<double> once = passage(n2 * c2, thickness_nm, wavelength_nm).factor();
  const std::complex<double> twice = once * once;
  const Amplitudes beams = {
      wall12.r_s + wall12.t_s * wall21.t_s * wall23.r_s * twice,  // (11)
      wall12.r_p + wall12.t_p * wall21.t_p * wall23.r_p * twice,
      wall12.t_s * wall23.t_s * once,  // (12)
      wall12.t_p * wall23.t_p * once,
  };
  return powers_of(beams, n1, n3, incidence);
}

WallAverages wall_averages(const Powers& powers) {
  return {(std::min(1.0, powers.R_s) + std::min(1.0, powers.R_p)) / 2, (powers.T_s + powers.T_p) / 2};
}

}  // namespace shabon::optics
