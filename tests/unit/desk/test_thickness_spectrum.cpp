// From spectra to thicknesses: what was put in comes out, as surely as it is said.
#include <gtest/gtest.h>

#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/thickness_spectrum.h"
#include "thickness_films.h"

namespace shabon::desk {
namespace {

struct Grid {
  double first_nm = 400, last_nm = 800, step_nm = 5;
  std::vector<double> angles_deg = {0};
};

// What a photometer would measure; noise is the standard deviation added to every share.
MeasuredSpectrum measured(const UnknownFilm& film, std::span<const double> thickness_nm,
                          std::vector<Quantity> quantities, const Grid& grid = {}, double noise = 0,
                          std::uint64_t seed = 1) {
  Pcg32 random(seed);
  std::vector<ModelRow> rows;
  MeasuredSpectrum spectrum{quantities, {}};
  for (const double angle_deg : grid.angles_deg)
    for (double nm = grid.first_nm; nm <= grid.last_nm; nm += grid.step_nm) {
      rows.push_back({nm, optics::incidence_from(Degrees(angle_deg))});
      spectrum.rows.push_back({nm, angle_deg, {}});
    }
  const optics::Stack stack = known_stack(film, thickness_nm);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const optics::Powers p = film_powers(stack, optics::Interference::airy, rows[i].incidence, rows[i].wavelength_nm);
    const double all[] = {(p.R_s + p.R_p) / 2, p.R_s, p.R_p, (p.T_s + p.T_p) / 2, p.T_s, p.T_p};
    for (const Quantity quantity : quantities)
      spectrum.rows[i].shares.push_back(all[static_cast<std::size_t>(quantity)] + noise * normal(random));
  }
  return spectrum;
}

SpectrumAnswer answer_to(const SpectrumQuery& query) {
  const Result<SpectrumAnswer> answer = thickness_from_spectrum(query);
  EXPECT_TRUE(answer.ok()) << to_text(answer.errors());
  return answer ? *answer : SpectrumAnswer{};
}

struct Film {
  const char* expression;
  std::vector<double> thickness_nm;
  std::vector<Quantity> quantities = {Quantity::R};
  Grid grid = {};
};

const Film films[] = {
    {"air | water ? | air", {412.3}},
    {"air | water ? | air", {7.5}},
    {"air | SiO2 ? | Si", {103.7}},
    {"air | SiO2 ? | Si", {1999}},
    {"air | 1.47 ? | water", {633.25}, {Quantity::R_s, Quantity::R_p}, {400, 800, 4, {20, 60}}},
    {"air | TiO2 ? | Ti", {88}, {Quantity::R}, {380, 780, 10, {0}}},
    {"air | Al2O3 ? | Al", {310}},
    {"air | Ag ? | glass", {22}, {Quantity::T}},
    {"air | 1.5 0..20um | Si", {12345.6}, {Quantity::R}, {400, 800, 1, {0}}},
    {"air | MgF2 ? | glass 1mm incoherent | air", {480}, {Quantity::T}},
    {"air | Si3N4 ? | SiO2 ? | Si", {120, 310}},
    {"air | TiO2 0..300nm | SiO2 0..300nm | glass", {61, 97}, {Quantity::R, Quantity::T}},
    {"air | (ZnS 20..120nm | MgF2 20..200nm)^5 | glass", {58, 99}},
    {"air | Ag 0..60nm | SiO2 0..500nm | Ag 0..60nm | glass", {25, 180, 40}, {Quantity::R, Quantity::T}},
    {"air | 1.46 0..500nm | 2.1 0..300nm | 1.46 0..500nm | Si",
     {210, 75, 330},
     {Quantity::R_s, Quantity::R_p},
     {400, 900, 5, {0, 55}}},
};

TEST(ThicknessFromSpectrum, GivesBackWhatWasPutIn) {
  for (const Film& film : films) {
    const UnknownFilm unknown = unknown_film(film.expression);
    const SpectrumAnswer answer =
        answer_to({unknown, measured(unknown, film.thickness_nm, film.quantities, film.grid)});
    ASSERT_FALSE(answer.candidates.empty());
    const SpectrumCandidate& best = answer.candidates.front();
    for (std::size_t j = 0; j < film.thickness_nm.size(); ++j)
      EXPECT_NEAR(best.thickness_nm[j], film.thickness_nm[j], 1e-4) << film.expression << " unknown " << j;
    EXPECT_LT(best.rms, 1e-9) << film.expression;
    EXPECT_EQ(answer.in_95_percent, 1u) << film.expression;
  }
}

// The true thickness lies within one standard error in 68 % of cases and within two in 95 %.
TEST(ThicknessFromSpectrum, StandardErrorsAreAsStated) {
  struct Rate {
    int inside1 = 0, inside2 = 0, all = 0;
  } rate;
  for (const Film& film : films) {
    if (film.thickness_nm.size() > 2 || film.grid.last_nm - film.grid.first_nm > 420) continue;
    if (std::string_view(film.expression).find("incoherent") != std::string_view::npos) continue;
    UnknownFilm unknown = unknown_film(film.expression);
    for (std::size_t j = 0; j < unknown.unknowns.size(); ++j) {  // near the truth, for speed; ends stay far away
      unknown.unknowns[j].low_nm = std::max(0.0, film.thickness_nm[j] - 60);
      unknown.unknowns[j].high_nm = film.thickness_nm[j] + 60;
    }
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const SpectrumAnswer answer =
          answer_to({unknown, measured(unknown, film.thickness_nm, film.quantities, film.grid, 5e-4, seed)});
      for (std::size_t j = 0; j < film.thickness_nm.size(); ++j) {
        const auto error_nm = answer.candidates.front().standard_error_nm[j];
        ASSERT_TRUE(error_nm) << film.expression;
        const double off = std::abs(answer.candidates.front().thickness_nm[j] - film.thickness_nm[j]) / *error_nm;
        rate.inside1 += off < 1, rate.inside2 += off < 2, ++rate.all;
      }
    }
  }
  ASSERT_GT(rate.all, 300);
  EXPECT_NEAR(static_cast<double>(rate.inside1) / rate.all, 0.683, 0.06);
  EXPECT_NEAR(static_cast<double>(rate.inside2) / rate.all, 0.954, 0.03);
}

}  // namespace
}  // namespace shabon::desk
