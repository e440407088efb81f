#include "shabon/desk/shortcuts_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/desk/fringes.h"
#include "shabon/desk/kernel/sweep_rows.h"
#include "shabon/optics/reference/fresnel.h"
#include "shabon/optics/reference/phase.h"

namespace shabon::desk {

using Complex = std::complex<double>;

namespace {

// Of amplitude 1 and the same phase; 1 for 0.
Complex direction(Complex amplitude) {
  const double modulus = std::abs(amplitude);
  return modulus > 0 ? amplitude / modulus : Complex(1);
}

}  // namespace

Complex schlick_amplitude(Complex n1, optics::Incidence incidence, Complex n_a, Complex n_b) {
  const Complex at_normal = (n_a - n_b) / (n_a + n_b);
  const Complex lower = n_a.real() <= n_b.real() ? n_a : n_b;
  const double cosine = std::clamp(optics::refracted_cosine(n1, incidence, lower).real(), 0.0, 1.0);
  const double share = std::norm(at_normal);
  return direction(at_normal) * std::sqrt(share + (1 - share) * std::pow(1 - cosine, 5));
}

Complex average_amplitude(Complex n1, optics::Incidence incidence, Complex n_a, Complex n_b) {
  const optics::InterfaceAmplitudes wall = optics::fresnel(n_a, optics::refracted_cosine(n1, incidence, n_a), n_b,
                                                           optics::refracted_cosine(n1, incidence, n_b));
  return direction(wall.r_s) * std::sqrt((std::norm(wall.r_s) + std::norm(wall.r_p)) / 2);
}

FilmOfWalls::FilmOfWalls(WallAmplitude amplitude, Complex n1, Complex n2, Complex n3, optics::Incidence incidence,
                         double wavelength_nm)
    : r12_(amplitude(n1, incidence, n1, n2)),
      r23_(amplitude(n1, incidence, n2, n3)),
      normal_index_(optics::normal_index(n1, incidence, n2)),
      wavelength_nm_(wavelength_nm) {}

WallShares FilmOfWalls::at(double thickness_nm) const {
  const Complex once = optics::passage(normal_index_, thickness_nm, wavelength_nm_).factor();
  return shares(once, once * once);
}

WallShares FilmOfWalls::mean(double thickness_nm, double fringes) const {
  if (fringes <= most_fringes_per_nm) return at(thickness_nm);
  const double counted = fringes > many_fringes ? 1 : fringes;
  const Complex once = optics::passage(normal_index_, thickness_nm, wavelength_nm_).factor();
  WallShares sum;
  for (int i = 0; i < looks_at_fringes; ++i) {
    const double turns = counted * ((i + 0.5) / looks_at_fringes - 0.5);
    const WallShares look = shares(once, once * once * std::polar(1.0, 2 * std::numbers::pi * turns));
    sum.reflected += look.reflected / looks_at_fringes, sum.transmitted += look.transmitted / looks_at_fringes;
  }
  return sum;
}

WallShares FilmOfWalls::shares(Complex once, Complex twice) const {
  const double wall12 = std::norm(r12_), wall23 = std::norm(r23_);
  if (wall12 >= 1) return {1, 0};  // also where the sum is 0/0
  const Complex sum = 1.0 + r12_ * r23_ * twice;
  return {std::norm((r12_ + r23_ * twice) / sum),
          std::max(0.0, (1 - wall12) * (1 - wall23)) * std::norm(once) / std::norm(sum)};
}

}  // namespace shabon::desk
