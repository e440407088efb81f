#include "shabon/optics/reference/no_interference.h"

#include <algorithm>
#include <cmath>

#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/phase.h"

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

// What a wall with r = (u1 - u2)/(u1 + u2) does not reflect, 1 - |r|^2, without the subtraction.
double not_reflected(Complex u1, Complex u2) {
  const double sum = norm(u1 + u2);
  return sum == 0 ? 1 : 4 * real(u1 * conj(u2)) / sum;
}

// One polarisation of the film: u = n c for s, c/n for p.
struct Wave {
  Complex u1, u2, u3;
  Complex r12, t12, t21, r23, t23;
  double power_ratio;  // of equal amplitudes in the third and the first medium (9)
};

struct Intensities {
  double R, T;
};

// (14). T12 T21 and T12 T23 need no power of the film itself: it cancels.
Intensities sum_of_intensities(const Wave& wave, const Passage& film, bool lossless_incidence) {
  const double R12 = norm(wave.r12), R23 = norm(wave.r23);
  const double passes_once = std::exp(-2 * film.loss);  // A
  const double not_returned =                           // 1 - R21 R23 A^2
      not_reflected(wave.u1, wave.u2) + R12 * (not_reflected(wave.u2, wave.u3) - R23 * std::expm1(-4 * film.loss));
  if (not_returned <= 0) return {1, 0};
  double R = R12 + norm(wave.t12 * wave.t21) * R23 * passes_once * passes_once / not_returned;
  double T = norm(wave.t12 * wave.t23) * wave.power_ratio * passes_once / not_returned;
  if (lossless_incidence) {
    R = std::min(R, 1.0);
    T = std::min(T, 1 - R);
  }
  return {R, T};
}

}  // namespace

Powers without_interference(Complex n1, Complex n2, Complex n3, double thickness_nm, Incidence incidence,
                            double wavelength_nm) {
  const Complex c1 = incidence.cos_i;
  const Complex c2 = refracted_cosine(n1, incidence, n2);
  const Complex c3 = refracted_cosine(n1, incidence, n3);
  const InterfaceAmplitudes wall12 = fresnel(n1, c1, n2, c2);
  const InterfaceAmplitudes wall21 = fresnel(n2, c2, n1, c1);
  const InterfaceAmplitudes wall23 = fresnel(n2, c2, n3, c3);
  const Powers ratio = powers_of({0, 0, 1, 1}, n1, n3, incidence);
  const Passage film = passage(n2 * c2, thickness_nm, wavelength_nm);
  const bool lossless_incidence = n1.imag() == 0;
  const Wave s = {n1 * c1, n2 * c2, n3 * c3, wall12.r_s, wall12.t_s, wall21.t_s, wall23.r_s, wall23.t_s, ratio.T_s};
  const Wave p = {c1 / n1, c2 / n2, c3 / n3, wall12.r_p, wall12.t_p, wall21.t_p, wall23.r_p, wall23.t_p, ratio.T_p};
  const Intensities sum_s = sum_of_intensities(s, film, lossless_incidence);
  const Intensities sum_p = sum_of_intensities(p, film, lossless_incidence);
  return {sum_s.R, sum_p.R, sum_s.T, sum_p.T};
}

}  // namespace shabon::optics
