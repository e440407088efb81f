#include "shabon/optics/reference/ellipsometry.h"

#include <cmath>
#include <numbers>

namespace shabon::optics {

namespace {

using Complex = std::complex<double>;

constexpr double degrees_per_radian = 180 / std::numbers::pi;

double phase_deg(Complex amplitude) { return std::arg(amplitude) * degrees_per_radian; }

Ellipsometry ratio(Complex p, Complex s) {
  // conj(p/s) has the phase of s conj(p); written out, so that it is 0 and not a sign of zero where p or s vanishes.
  const double angle_deg = p == 0.0 || s == 0.0 ? 0 : phase_deg(s / std::abs(s) * conj(p / std::abs(p)));
  return {std::atan2(std::abs(p), std::abs(s)) * degrees_per_radian, angle_deg < -90 ? angle_deg + 360 : angle_deg};
}

}  // namespace

Ellipsometry ellipsometry(const Amplitudes& amplitudes) { return ratio(amplitudes.r_p, amplitudes.r_s); }

Ellipsometry transmission_ellipsometry(const Amplitudes& amplitudes) { return ratio(amplitudes.t_p, amplitudes.t_s); }

Phases phases(const Amplitudes& amplitudes) {
  return {phase_deg(amplitudes.r_s), phase_deg(amplitudes.r_p), phase_deg(amplitudes.t_s), phase_deg(amplitudes.t_p)};
}

}  // namespace shabon::optics
