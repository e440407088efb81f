#include "shabon/optics/reference/mueller.h"

#include <algorithm>
#include <cmath>

#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/phase.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

// Never more polarised than light can be: in metals the sums of (14) are bounded, and so must be what goes between s
// and p.
MuellerRow row(double power_s, double power_p, Complex s_times_conj_p) {
  const double most = std::sqrt(std::max(0.0, power_s * power_p)), size = abs(s_times_conj_p);
  if (size > most) s_times_conj_p *= most / size;
  return {(power_s + power_p) / 2, (power_s - power_p) / 2, s_times_conj_p.real(), s_times_conj_p.imag()};
}

// The mean over phase of r_s conj(r_p) and t_s conj(t_p): the sums of (14) with the product of both polarisations in
// the place of each wall's power.
FilmRows rows_without_phase(Complex n1, Complex n2, Complex n3, double thickness_nm, Incidence incidence,
                            double wavelength_nm) {
  const Complex c1 = incidence.cos_i, c2 = refracted_cosine(n1, incidence, n2),
                c3 = refracted_cosine(n1, incidence, n3);
  const InterfaceAmplitudes in = fresnel(n1, c1, n2, c2), out = fresnel(n2, c2, n1, c1), far = fresnel(n2, c2, n3, c3);
  const double passes_once = std::exp(-2 * passage(n2 * c2, thickness_nm, wavelength_nm).loss);
  const Complex far_wall = far.r_s * conj(far.r_p);
  const Complex returned = out.r_s * conj(out.r_p) * far_wall * passes_once * passes_once;
  const Complex into = in.t_s * conj(in.t_p), back = out.t_s * conj(out.t_p), beyond = far.t_s * conj(far.t_p);
  const Powers p = without_interference(n1, n2, n3, thickness_nm, incidence, wavelength_nm);
  if (returned == 1.0) return {row(p.R_s, p.R_p, in.r_s * conj(in.r_p)), {}};  // grazing: nothing enters
  const Powers ratio = powers_of({0, 0, 1, 1}, n1, n3, incidence);
  return {
      row(p.R_s, p.R_p, in.r_s * conj(in.r_p) + into * back * far_wall * passes_once * passes_once / (1.0 - returned)),
      row(p.T_s, p.T_p, into * beyond * passes_once * std::sqrt(ratio.T_s * ratio.T_p) / (1.0 - returned))};
}

}  // namespace

FilmRows film_rows(Interference interference, Complex n1, Complex n2, Complex n3, double thickness_nm,
                   Incidence incidence, double wavelength_nm) {
  if (interference == Interference::two_beam) {
    const WallAverages mean = wall_averages(two_beam(n1, n2, n3, thickness_nm, incidence, wavelength_nm));
    return {{mean.f_h, 0, 0, 0}, {mean.f_t, 0, 0, 0}};
  }
  if (interference == Interference::none) return rows_without_phase(n1, n2, n3, thickness_nm, incidence, wavelength_nm);
  const Amplitudes x = airy_amplitudes(n1, n2, n3, thickness_nm, incidence, wavelength_nm);
  const Powers p = powers_of(x, n1, n3, incidence);
  const Powers ratio = powers_of({0, 0, 1, 1}, n1, n3, incidence);
  return {row(p.R_s, p.R_p, x.r_s * conj(x.r_p)),
          row(p.T_s, p.T_p, x.t_s * conj(x.t_p) * std::sqrt(ratio.T_s * ratio.T_p))};
}

}  // namespace shabon::optics
