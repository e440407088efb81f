// The lossless film between equal media against the exact reference, over the whole required range.
#include "shabon/optics/packet/free_film.h"

#include <gtest/gtest.h>

#include "crossing.h"
#include "shabon/optics/reference/airy.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {
namespace {

struct Errors {
  Worst powers, blocks, energy, coherence;

  void expect() const {
    powers.expect_within(required, "R and T");
    blocks.expect_within(required, "Mueller blocks");
    energy.expect_within(3e-7, "R + T - 1");
    coherence.expect_within(1.2e-6, "|c + id|^2 - X_s X_p");
  }
};

void compare_block(const MuellerBlock<lanes>& block, int i, std::complex<double> x_s, std::complex<double> x_p,
                   const FilmCase& film, Errors& errors) {
  const auto where = [&] { return film.lane_text(i); };
  const double s = norm(x_s), p = norm(x_p);
  const std::complex<double> both = x_s * conj(x_p);
  errors.blocks.see(std::abs(block.a[i] - (s + p) / 2), where);
  errors.blocks.see(std::abs(block.b[i] - (s - p) / 2), where);
  errors.blocks.see(std::abs(block.c[i] - both.real()), where);
  errors.blocks.see(std::abs(block.d[i] - both.imag()), where);
  const double a = block.a[i], b = block.b[i], c = block.c[i], d = block.d[i];
  errors.coherence.see(std::abs(c * c + d * d - (a + b) * (a - b)), where);
}

template <class L, class D>
FilmPowers<lanes> powers_of(const Crossing<L, D>& at) {
  return free_film_powers(at.factors(), film_phase_sin2(at.phase_cycles));
}

template <class L, class D>
FilmMueller<lanes> mueller_of(const Crossing<L, D>& at) {
  return free_film_mueller(at.factors(), at.turn(), film_phase(at.phase_cycles));
}

template <class L, class D>
void compare(const FilmCase& film, const Crossing<L, D>& at, Errors& errors) {
  const FilmPowers<lanes> powers = powers_of(at);
  const FilmMueller<lanes> mueller = mueller_of(at);
  for (int i = 0; i < lanes; ++i) {
    const auto where = [&] { return film.lane_text(i); };
    const Amplitudes exact =
        airy_amplitudes(film.n1[i], film.n2[i], film.n1[i], film.thickness_nm, film.incidence(), film.wavelength_nm[i]);
    errors.powers.see(std::abs(powers.R_s[i] - norm(exact.r_s)), where);
    errors.powers.see(std::abs(powers.R_p[i] - norm(exact.r_p)), where);
    errors.powers.see(std::abs(powers.T_s[i] - norm(exact.t_s)), where);
    errors.powers.see(std::abs(powers.T_p[i] - norm(exact.t_p)), where);
    compare_block(mueller.reflected, i, exact.r_s, exact.r_p, film, errors);
    compare_block(mueller.transmitted, i, exact.t_s, exact.t_p, film, errors);
    errors.energy.see(std::abs(static_cast<double>(powers.R_s[i]) + powers.T_s[i] - 1), where);
    errors.energy.see(std::abs(static_cast<double>(powers.R_p[i]) + powers.T_p[i] - 1), where);
    errors.energy.see(std::abs(static_cast<double>(mueller.reflected.a[i]) + mueller.transmitted.a[i] - 1), where);
  }
}

TEST(FreeFilm, AgreesWithTheReferenceOnAGrid) {
  Errors errors;
  visit_film_grid([&](const FilmCase& film) { compare(film, constant_crossing(film), errors); });
  errors.expect();
}

TEST(FreeFilm, AgreesWithTheReferenceAnywhere) {
  Errors errors;
  Pcg32 random(1989);
  for (int k = 0; k < 60000; ++k) {
    const FilmCase film = random_film(random);
    compare(film, constant_crossing(film), errors);
  }
  errors.expect();
}

TEST(FreeFilm, AgreesWithTheReferenceForDispersiveMedia) {
  Errors errors;
  Pcg32 random(5);
  for (int k = 0; k < 40000; ++k) {
    const FilmCase film = random_dispersive_film(random);
    compare(film, dispersive_crossing(film), errors);
  }
  errors.expect();
}

// Packets of one index and of one index per lane are two forms of one kernel.
TEST(FreeFilm, ADispersiveKernelWithOneIndexIsTheConstantOne) {
  Pcg32 random(6);
  for (int k = 0; k < 1000; ++k) {
    const FilmCase film = random_film(random);
    const auto one = mueller_of(constant_crossing(film));
    const auto each = mueller_of(dispersive_crossing(film));
    for (int i = 0; i < lanes; ++i) {
      EXPECT_NEAR(one.reflected.a[i], each.reflected.a[i], 5e-7);
      EXPECT_NEAR(one.transmitted.d[i], each.transmitted.d[i], 5e-7);
    }
  }
}

FilmCase film_at(double n1, double n2, double thickness_nm, double cos_i) {
  FilmCase film;
  spread_wavelengths(film, 0.5);
  constant_indices(film, n1, n2);
  film.thickness_nm = thickness_nm;
  film.cos_i = cos_i;
  return film;
}

// Rays along the film: every number is finite, the energy is kept, and all light is reflected unless there is no film.
TEST(FreeFilm, RaysAlongTheFilm) {
  for (const double n1 : {1.0, 1.333})
    for (const double n2 : {1.0, 1.0001, 1.333, 1.5, 4.0})
      for (const double thickness_nm : {0.0, 1e-3, 100.0, 550.0, 2000.0})
        for (const double cos_i : {0.0, 1e-12, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4}) {
          if (n2 < n1) continue;
          const FilmCase film = film_at(n1, n2, thickness_nm, cos_i);
          const auto powers = powers_of(constant_crossing(film));
          const auto mueller = mueller_of(constant_crossing(film));
          for (int i = 0; i < lanes; ++i) {
            EXPECT_NEAR(powers.R_s[i] + powers.T_s[i], 1, 3e-7) << film.lane_text(i);
            EXPECT_NEAR(powers.R_p[i] + powers.T_p[i], 1, 3e-7) << film.lane_text(i);
            for (const auto& block : {mueller.reflected, mueller.transmitted}) {
              EXPECT_GE(block.a[i], 0) << film.lane_text(i);
              EXPECT_LE(std::abs(block.c[i]) + std::abs(block.d[i]), 1.5) << film.lane_text(i);
            }
            if (thickness_nm == 0 || n2 == n1) {
              EXPECT_EQ(powers.R_s[i], 0) << film.lane_text(i);
              EXPECT_NEAR(powers.T_s[i], 1, 3e-7) << film.lane_text(i);
            } else if (thickness_nm >= 100 && cos_i == 0 && n2 > 1.01 * n1) {
              EXPECT_NEAR(powers.R_s[i], 1, 1e-6) << film.lane_text(i);
            }
          }
        }
}

TEST(FreeFilm, NothingIsReflectedByAHalfWave) {
  const double q2 = 1.5;
  for (const double half_waves : {1.0, 2.0, 7.0}) {
    const FilmCase film = film_at(1, 1.5, 100, 1);
    const auto powers =
        free_film_powers(constant_crossing(film).factors(), film_phase_sin2(Double(half_waves / (2 * q2)) * q2));
    for (int i = 0; i < lanes; ++i) EXPECT_EQ(powers.R_s[i], 0);
  }
}

TEST(FreeFilm, NoParallelLightIsReflectedAtBrewstersAngle) {
  const double n = as_float(1.5);
  const FilmCase film = film_at(1, n, 240, std::sqrt(1 / (1 + n * n)));
  const auto powers = powers_of(constant_crossing(film));
  for (int i = 0; i < lanes; ++i) {
    EXPECT_LT(powers.R_p[i], 1e-12);
    EXPECT_GT(powers.R_s[i], 1e-3);
  }
}

}  // namespace
}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
