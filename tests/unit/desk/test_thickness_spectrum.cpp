// From spectra to thicknesses: what was put in comes out, as surely as it is said.
#include <gtest/gtest.h>

#include <algorithm>

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

// Few values and much noise: several thicknesses remain, and the weights say how likely each is.
TEST(ThicknessFromSpectrum, WeightsOfAmbiguousSpectraAreRates) {
  Pcg32 random(5);
  const UnknownFilm film = unknown_film("air | water 100..900nm | air");
  double stated = 0, hits = 0, ambiguous = 0;
  constexpr int trials = 300;
  for (int i = 0; i < trials; ++i) {
    const double truth_nm = random.uniform(100, 900);
    SpectrumQuery query{film, {}};
    query.noise = 0.01;
    query.measured =
        measured(film, std::vector{truth_nm}, {Quantity::R}, {450, 650, 50, {0}}, 0.01, static_cast<std::uint64_t>(i));
    const SpectrumAnswer answer = answer_to(query);
    ambiguous += answer.in_95_percent > 1;
    const auto heaviest =
        std::max_element(answer.candidates.begin(), answer.candidates.end(),
                         [](const SpectrumCandidate& a, const SpectrumCandidate& b) { return a.weight < b.weight; });
    stated += heaviest->weight;
    const double off_nm = std::abs(heaviest->thickness_nm[0] - truth_nm);
    hits += heaviest->standard_error_nm[0] && off_nm < 4 * *heaviest->standard_error_nm[0];
  }
  EXPECT_GT(ambiguous, trials / 10);
  EXPECT_NEAR(hits / trials, stated / trials, 0.08);
}

// A film described with the wrong index: what is left is no noise, and the errors say so.
TEST(ThicknessFromSpectrum, ResidualsThatAreAlikeWidenTheErrors) {
  const UnknownFilm truth = unknown_film("air | 1.47 ? | Si"), believed = unknown_film("air | 1.46 ? | Si");
  SpectrumQuery query{believed, measured(truth, std::vector{700.0}, {Quantity::R}, {}, 1e-4)};
  const SpectrumAnswer answer = answer_to(query);
  EXPECT_GT(answer.widening, 3);
  const double off_nm = std::abs(answer.candidates.front().thickness_nm[0] - 700 * 1.47 / 1.46);
  EXPECT_LT(off_nm, 4 * *answer.candidates.front().standard_error_nm[0]);
  query.noise = 1e-4;
  EXPECT_TRUE(answer_to(query).noise_exceeded);
  // Nothing of this where the film is as described.
  SpectrumQuery right{truth, measured(truth, std::vector{700.0}, {Quantity::R}, {}, 1e-4)};
  EXPECT_EQ(answer_to(right).widening, 1);
  right.noise = 1e-4;
  EXPECT_FALSE(answer_to(right).noise_exceeded);
  EXPECT_EQ(answer_to(right).noise, 1e-4);
}

TEST(ThicknessFromSpectrum, SaysWhatASpectrumLeavesOpen) {
  // Only the sum of two layers of one medium matters; below an opaque layer nothing does.
  for (const auto& [expression, thickness_nm] :
       {std::pair{"air | 1.46 0..400nm | 1.46 0..400nm | Si", std::vector{120.0, 150.0}},
        std::pair{"air | 1.46 0..400nm | Al 300nm | 1.46 0..400nm | Si", std::vector{120.0, 150.0}}}) {
    const UnknownFilm film = unknown_film(expression);
    SpectrumQuery query{film, measured(film, thickness_nm, {Quantity::R})};
    query.noise = 1e-3;
    const SpectrumCandidate best = answer_to(query).candidates.front();
    EXPECT_FALSE(best.standard_error_nm[1]) << expression;
    EXPECT_TRUE(best.correlation.empty());
    EXPECT_LT(best.rms, 1e-6) << expression;
  }
}

TEST(ThicknessFromSpectrum, TheScaleMayBeUnknown) {
  const UnknownFilm film = unknown_film("air | Si3N4 0..300nm | SiO2 0..300nm | Si");
  SpectrumQuery query{film, measured(film, std::vector{80.0, 222.0}, {Quantity::R}, {}, 5e-4)};
  for (MeasuredRow& row : query.measured.rows) row.shares[0] *= 0.6;
  EXPECT_GT(answer_to(query).candidates.front().rms, 0.02);
  query.ignore_scale = true;
  const SpectrumCandidate best = answer_to(query).candidates.front();
  EXPECT_NEAR(best.scale, 0.6, 2e-3);
  EXPECT_NEAR(best.thickness_nm[0], 80, 4 * *best.standard_error_nm[0]);
  EXPECT_NEAR(best.thickness_nm[1], 222, 4 * *best.standard_error_nm[1]);
}

// A thin oxide darkens silicon nearly as a smaller scale does: the error must count what the scale could do.
TEST(ThicknessFromSpectrum, AnUnknownScaleCosts) {
  const UnknownFilm film = unknown_film("air | SiO2 0..60nm | Si");
  double inside = 0, error_nm = 0, known_error_nm = 0;
  constexpr int trials = 200;
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    SpectrumQuery query{film, measured(film, std::vector{30.0}, {Quantity::R}, {500, 800, 10, {0}}, 1e-3, seed)};
    known_error_nm += answer_to(query).candidates.front().standard_error_nm[0].value_or(60) / trials;
    query.ignore_scale = true;
    const SpectrumCandidate best = answer_to(query).candidates.front();
    ASSERT_TRUE(best.standard_error_nm[0]);
    error_nm += *best.standard_error_nm[0] / trials;
    inside += std::abs(best.thickness_nm[0] - 30) < *best.standard_error_nm[0];
  }
  EXPECT_GT(error_nm, 1.5 * known_error_nm);
  EXPECT_NEAR(inside / trials, 0.683, 0.1);
}

TEST(ThicknessFromSpectrum, OrderOfRowsAndThreadsDoNotMatter) {
  const UnknownFilm film = unknown_film("air | 1.46 0..300nm | 2.1 0..300nm | Si");
  SpectrumQuery query{
      film, measured(film, std::vector{80.0, 222.0}, {Quantity::R_s, Quantity::R_p}, {400, 800, 10, {20, 60}}, 1e-3)};
  const SpectrumAnswer first = answer_to(query), again = answer_to(query);
  std::reverse(query.measured.rows.begin(), query.measured.rows.end());
  const SpectrumAnswer reversed = answer_to(query);
  for (const SpectrumAnswer* other : {&again, &reversed}) {
    ASSERT_EQ(other->candidates.size(), first.candidates.size());
    for (std::size_t i = 0; i < first.candidates.size(); ++i) {
      EXPECT_EQ(other->candidates[i].thickness_nm, first.candidates[i].thickness_nm);
      EXPECT_EQ(other->candidates[i].weight, first.candidates[i].weight);
    }
  }
}

TEST(ThicknessFromSpectrum, TellsWhatTheSearchCannotPromise) {
  const UnknownFilm thick = unknown_film("air | 1.5 0..100um | Si");
  SpectrumQuery query{thick, measured(thick, std::vector{20'000.0}, {Quantity::R}, {400, 800, 5, {0}})};
  EXPECT_GT(answer_to(query).fringes_between_rows, 0.5);
  EXPECT_LT(answer_to(query).search_step_fringes, 0.1);
  const UnknownFilm wide = unknown_film("air | 1.5 0..9um | 2 0..9um | 1.4 0..9um | Si");
  const double known[] = {1000, 2000, 3000};
  EXPECT_GT(answer_to({wide, measured(wide, known, {Quantity::R}, {400, 800, 20, {0}})}).search_step_fringes, 0.25);
}

TEST(ThicknessFromSpectrum, RefusesWhatItCannotAnswer) {
  const UnknownFilm film = unknown_film("air | water ? | air");
  const SpectrumQuery good{film, measured(film, std::vector{300.0}, {Quantity::R}, {400, 500, 20, {0}})};
  const auto message = [](const SpectrumQuery& query) {
    const auto answer = thickness_from_spectrum(query);
    return answer ? std::string() : answer.errors().front().message;
  };
  EXPECT_EQ(message(good), "");
  const auto expect = [&](const char* part, const auto& change) {
    SpectrumQuery bad = good;
    change(bad);
    EXPECT_NE(message(bad).find(part), std::string::npos) << message(bad);
  };
  expect("more measured values", [](SpectrumQuery& q) { q.measured.rows.resize(1); });
  expect("more measured values", [](SpectrumQuery& q) { q.measured.rows.resize(2), q.ignore_scale = true; });
  expect("one measured quantity", [](SpectrumQuery& q) { q.measured.quantities.clear(); });
  expect("every quantity", [](SpectrumQuery& q) { q.measured.rows[1].shares.clear(); });
  expect("finite shares", [](SpectrumQuery& q) { q.measured.rows[1].shares[0] = NAN; });
  expect("wavelengths > 0", [](SpectrumQuery& q) { q.measured.rows[1].wavelength_nm = 0; });
  expect("angles of 0..90", [](SpectrumQuery& q) { q.measured.rows[1].incidence_deg = 91; });
  expect("noise > 0", [](SpectrumQuery& q) { q.noise = 0; });
  expect("unknown thickness", [](SpectrumQuery& q) { q.film.unknowns.clear(); });
  expect("at most 4", [](SpectrumQuery& q) { q.film.unknowns.resize(5); });
  expect("no layer 2", [](SpectrumQuery& q) { q.film.unknowns[0].layers = {1}; });
  expect("two unknown", [](SpectrumQuery& q) { q.film.unknowns.push_back(q.film.unknowns[0]); });
  expect("that rises", [](SpectrumQuery& q) { q.film.unknowns[0].high_nm = 0; });
}

}  // namespace
}  // namespace shabon::desk
