// The model that thicknesses are fitted with, against the reference.
#include <gtest/gtest.h>

#include "shabon/desk/film_spectrum.h"
#include "thickness_films.h"

namespace shabon::desk {
namespace {

// One and several unknowns, tied ones, lossless, absorbing, evanescent and opaque layers, incoherent ones, an absorbing
// first medium.
constexpr const char* films[] = {
    "air | water ? | air",
    "air | SiO2 ? | Si",
    "air | TiO2 ? | Ti",
    "air | Si3N4 ? | SiO2 ? | Si",
    "1 | 1.38 99.6nm | 2.2 ? | 1.38 20nm | 1.9 ? | 1.52",
    "air | (ZnS ? | MgF2 ?)^5 | glass",
    "air | (ZnS 58nm | MgF2 ?)^200 | glass",
    "air | Ag ? | SiO2 ? | Ag ? | glass",
    "1.52 | 1 ? | 1.52",
    "1 | Al 2um | 1.5 ? | 1",
    "1 | Al 200um | 1.5 ? | Si",
    "1 | 1.5 ? | Al 200um | 1",
    "air | MgF2 ? | glass 1mm incoherent | MgF2 ? | air",
    "1.5+0.001i | 2 ? | 1.5",
    "air | 1.5 ? | 1.7 ? | 1.3 ? | 2+0.5i ? | 1.5+3i",
};

struct Case {
  UnknownFilm film;
  std::vector<ModelRow> rows;
  std::vector<Quantity> quantities;
};

Case case_of(const char* expression) {
  Case c{unknown_film(expression), {}, {}};
  for (const double incidence_deg : {0.0, 30.0, 70.0, 89.9})
    for (const double wavelength_nm : {400.0, 550.0, 701.5})
      c.rows.push_back({wavelength_nm, optics::incidence_from(Degrees(incidence_deg))});
  for (const QuantityEntry& entry : quantities()) c.quantities.push_back(entry.quantity);
  return c;
}

constexpr double thicknesses_nm[][4] = {
    {0, 0, 0, 0}, {100, 37, 250, 10}, {1234.5, 600, 0, 80}, {3, 5000, 17, 2}, {40, 40, 40, 40}};

std::vector<double> expected_shares(const Case& c, std::span<const double> thickness_nm) {
  const optics::Stack stack = known_stack(c.film, thickness_nm);
  std::vector<double> shares;
  for (const ModelRow& row : c.rows) {
    const optics::Powers p = film_powers(stack, optics::Interference::airy, row.incidence, row.wavelength_nm);
    for (const double share : {(p.R_s + p.R_p) / 2, p.R_s, p.R_p, (p.T_s + p.T_p) / 2, p.T_s, p.T_p})
      shares.push_back(share);
  }
  return shares;
}

TEST(ThicknessModel, IsTheReference) {
  for (const char* expression : films) {
    const Case c = case_of(expression);
    FilmModel model(c.film, c.rows, c.quantities);
    std::vector<double> shares(model.size());
    for (const auto& thickness_nm : thicknesses_nm) {
      for (std::size_t j = 0; j < model.unknowns(); ++j) model.set_thickness(j, thickness_nm[j]);
      model.shares(shares);
      const std::vector<double> expected = expected_shares(c, thickness_nm);
      for (std::size_t i = 0; i < shares.size(); ++i)
        ASSERT_NEAR(shares[i], expected[i], 1e-10) << expression << " " << thickness_nm[0] << " value " << i;
    }
  }
}

TEST(ThicknessModel, SlopesAreThoseOfTheShares) {
  constexpr double step_nm = 1e-4;
  for (const char* expression : films) {
    const Case c = case_of(expression);
    FilmModel model(c.film, c.rows, c.quantities);
    std::vector<double> shares(model.size()), same(model.size()), slopes(model.size() * model.unknowns());
    for (const auto& thickness_nm : thicknesses_nm) {
      if (thickness_nm[0] == 0) continue;  // the difference below would go below zero
      for (std::size_t j = 0; j < model.unknowns(); ++j) model.set_thickness(j, thickness_nm[j] + 1);
      model.shares_and_slopes(shares, slopes);
      model.shares(same);
      EXPECT_EQ(shares, same) << expression;
      std::vector<double> low(model.size()), high(model.size());
      for (std::size_t j = 0; j < model.unknowns(); ++j) {
        model.set_thickness(j, thickness_nm[j] + 1 - step_nm), model.shares(low);
        model.set_thickness(j, thickness_nm[j] + 1 + step_nm), model.shares(high);
        model.set_thickness(j, thickness_nm[j] + 1);
        for (std::size_t i = 0; i < shares.size(); ++i) {
          const double slope = (high[i] - low[i]) / (2 * step_nm);
          ASSERT_NEAR(slopes[j * model.size() + i], slope, 1e-5 * std::abs(slope) + 1e-8)
              << expression << " unknown " << j << " value " << i;
        }
      }
    }
  }
}

TEST(ThicknessModel, CountsFringes) {
  const ModelRow rows[] = {{400, optics::incidence_from(Degrees(30))}, {800, optics::incidence_from(Degrees(30))}};
  const double n_cos = std::sqrt(1.5 * 1.5 - 0.25);
  EXPECT_NEAR(fringes_per_nm(unknown_film("1 | 1.5 ? | 1"), 0, rows), 2 * n_cos / 400, 1e-15);
}

}  // namespace
}  // namespace shabon::desk
