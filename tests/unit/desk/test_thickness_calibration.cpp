// Few measured values of unknown noise: what is said to be sure is right as often as it says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/thickness_spectrum.h"
#include "thickness_films.h"

namespace shabon::desk {
namespace {

MeasuredSpectrum measured(const UnknownFilm& film, double thickness_nm, int rows, double noise, Pcg32& random) {
  const double known[] = {thickness_nm};
  const optics::Stack stack = known_stack(film, known);
  MeasuredSpectrum spectrum{{Quantity::R}, {}};
  for (int i = 0; i < rows; ++i) {
    const double nm = 400 + 300.0 * i / (rows - 1);
    const optics::Powers p = film_powers(stack, optics::Interference::airy, optics::incidence_from(Degrees(0)), nm);
    spectrum.rows.push_back({nm, 0, {p.R_s + noise * normal(random)}});
  }
  return spectrum;
}

// What was said and what was so, summed over films.
struct Rates {
  double films = 0, stated = 0, right = 0, inside = 0;

  void count(const SpectrumCandidate& said, double truth_nm) {
    const double half_nm = said.half_95_nm[0].value_or(1000), off_nm = std::abs(said.thickness_nm[0] - truth_nm);
    ++films, stated += said.weight, right += off_nm < 2.5 * half_nm, inside += off_nm < half_nm;
  }
};

const SpectrumCandidate& heaviest(const SpectrumAnswer& answer) {
  return *std::max_element(answer.candidates.begin(), answer.candidates.end(),
                           [](const SpectrumCandidate& a, const SpectrumCandidate& b) { return a.weight < b.weight; });
}

constexpr int rows_of[] = {2, 3, 4, 6, 10, 40};
constexpr double noises[] = {0, 1e-4, 1e-3, 1e-2};

TEST(ThicknessCalibration, SureStatementsAreRight) {
  constexpr int films = 16;  // of each kind
  constexpr double sure_from = 0.95;
  Pcg32 random(7);
  Rates sure, all, of_two_values;
  for (const char* expression : {"air | SiO2 0..1000nm | Si", "air | water 0..1000nm | air"})
    for (const int rows : rows_of)
      for (const double noise : noises)
        for (int i = 0; i < films; ++i) {
          const UnknownFilm film = unknown_film(expression);
          const double truth_nm = random.uniform(0, 1000);
          const auto answer = thickness_from_spectrum({film, measured(film, truth_nm, rows, noise, random)});
          ASSERT_TRUE(answer.ok());
          const SpectrumCandidate& said = heaviest(*answer);
          all.count(said, truth_nm);
          if (said.weight > sure_from) sure.count(said, truth_nm);
          if (said.weight > sure_from && rows == 2) of_two_values.count(said, truth_nm);
        }
  ASSERT_GT(sure.films, all.films / 2);
  EXPECT_NEAR(sure.right / sure.films, sure.stated / sure.films, 0.01);
  EXPECT_GT(sure.inside / sure.films, 0.95);
  EXPECT_GT(all.right / all.films, all.stated / all.films - 0.01);
  EXPECT_LT(of_two_values.films, 0.05 * all.films / std::size(rows_of));
}

// Two values that several thicknesses meet within the noise: the nearest by chance must not be the answer.
TEST(ThicknessCalibration, TwoValuesDoNotTellTheirNoise) {
  const UnknownFilm film = unknown_film("air | SiO2 ? | Si");
  SpectrumQuery query{film, {{Quantity::R}, {{400, 0, {0.27514}}, {700, 0, {0.33538}}}}};
  query.measured.step = 1e-5;
  const Result<SpectrumAnswer> answer = thickness_from_spectrum(query);
  ASSERT_TRUE(answer.ok());
  EXPECT_NEAR(answer->candidates.front().thickness_nm[0], 728.26, 0.01);
  EXPECT_LT(answer->candidates.front().weight, 0.6);
  EXPECT_GT(answer->in_95_percent, 3u);
  EXPECT_GT(*answer->candidates.front().half_95_nm[0], 4 * *answer->candidates.front().standard_error_nm[0]);
  EXPECT_EQ(answer->least_noise, least_noise);
  // Nor are coarse digits finer than they are.
  query.measured.step = 0.01;
  EXPECT_EQ(thickness_from_spectrum(query)->least_noise, 0.01 / std::sqrt(12.0));
  // Stated, it is believed.
  query.noise = 1e-4;
  const Result<SpectrumAnswer> stated = thickness_from_spectrum(query);
  EXPECT_GT(stated->candidates.front().weight, 0.99);
  EXPECT_NEAR(*stated->candidates.front().half_95_nm[0], 1.96 * *stated->candidates.front().standard_error_nm[0], 1e-4);
}

// With many values Student's distribution is the normal one, and the noise is what the residuals are.
TEST(ThicknessCalibration, ManyValuesTellTheirNoise) {
  const UnknownFilm film = unknown_film("air | SiO2 ? | Si");
  Pcg32 random(3);
  const Result<SpectrumAnswer> answer = thickness_from_spectrum({film, measured(film, 500, 400, 2e-3, random)});
  ASSERT_TRUE(answer.ok());
  const SpectrumCandidate& best = answer->candidates.front();
  EXPECT_NEAR(answer->noise, best.rms, 0.01 * best.rms);
  EXPECT_NEAR(answer->noise, 2e-3, 2e-4);
  EXPECT_NEAR(*best.half_95_nm[0] / *best.standard_error_nm[0], 1.96, 0.03);
}

}  // namespace
}  // namespace shabon::desk
