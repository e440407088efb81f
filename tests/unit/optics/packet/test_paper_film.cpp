// The two-beam film and the film without phase against their references.
#include "shabon/optics/packet/paper_film.h"

#include <gtest/gtest.h>

#include "crossing.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::optics {
inline namespace SHABON_REGISTERS {
namespace {

// The two-beam R exceeds 1 near grazing incidence: its error is relative to it there.
void compare_powers(const FilmPowers<lanes>& powers, int i, const Powers& exact, const FilmCase& film, Worst& worst) {
  const auto where = [&] { return film.lane_text(i); };
  worst.see(std::abs(powers.R_s[i] - exact.R_s) / std::max(1.0, exact.R_s), where);
  worst.see(std::abs(powers.R_p[i] - exact.R_p) / std::max(1.0, exact.R_p), where);
  worst.see(std::abs(powers.T_s[i] - exact.T_s), where);
  worst.see(std::abs(powers.T_p[i] - exact.T_p), where);
}

struct Errors {
  Worst two_beam, without_phase;

  void expect() const {
    two_beam.expect_within(required, "two-beam R and T");
    without_phase.expect_within(required, "R and T without phase");
  }
};

template <class L, class D>
void compare(const FilmCase& film, const Crossing<L, D>& at, Errors& errors) {
  const auto wall = wall_reflectance<L>(at.n1_squared, at.n2_squared, at.q1, at.q2);
  const auto beams = two_beam_powers(wall, film_phase_sin2(at.phase_cycles));
  const auto without = without_phase_powers<lanes>(wall);
  for (int i = 0; i < lanes; ++i) {
    const double n1 = film.n1[i], n2 = film.n2[i], wavelength_nm = film.wavelength_nm[i];
    compare_powers(beams, i, two_beam(n1, n2, n1, film.thickness_nm, film.incidence(), wavelength_nm), film,
                   errors.two_beam);
    compare_powers(without, i, without_interference(n1, n2, n1, film.thickness_nm, film.incidence(), wavelength_nm),
                   film, errors.without_phase);
  }
}

TEST(PaperFilm, AgreesWithTheReferenceOnAGrid) {
  Errors errors;
  visit_film_grid([&](const FilmCase& film) { compare(film, constant_crossing(film), errors); });
  errors.expect();
}

TEST(PaperFilm, AgreesWithTheReferenceAnywhere) {
  Errors errors;
  Pcg32 random(1989);
  for (int k = 0; k < 20000; ++k) {
    const FilmCase film = random_film(random);
    compare(film, constant_crossing(film), errors);
  }
  errors.expect();
}

TEST(PaperFilm, AgreesWithTheReferenceForDispersiveMedia) {
  Errors errors;
  Pcg32 random(7);
  for (int k = 0; k < 20000; ++k) {
    const FilmCase film = random_dispersive_film(random);
    compare(film, dispersive_crossing(film), errors);
  }
  errors.expect();
}

TEST(PaperFilm, RaysAlongTheFilmAreReflected) {
  FilmCase film;
  spread_wavelengths(film, 0.5);
  constant_indices(film, 1, 1.333);
  film.thickness_nm = 400;
  film.cos_i = 0;
  const auto at = constant_crossing(film);
  const auto wall = wall_reflectance<float>(at.n1_squared, at.n2_squared, at.q1, at.q2);
  const auto beams = two_beam_powers(wall, film_phase_sin2(at.phase_cycles));
  const auto without = without_phase_powers<lanes>(wall);
  for (int i = 0; i < lanes; ++i)
    for (const auto& powers : {beams, without}) {
      EXPECT_NEAR(powers.R_s[i], 1, 1e-6);
      EXPECT_NEAR(powers.R_p[i], 1, 1e-6);
      EXPECT_NEAR(powers.T_s[i], 0, 1e-6);
      EXPECT_NEAR(powers.T_p[i], 0, 1e-6);
    }
}

}  // namespace
}  // namespace SHABON_REGISTERS
}  // namespace shabon::optics
