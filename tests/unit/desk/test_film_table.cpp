// The table of a stack: its rows, columns and refusals.
#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/film_table.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

const optics::Stack mirror = *optics::parse_stack("air | Ag 30nm | SiO2 120nm | 1.8+0.05i 40nm | 1.5");
const std::vector<double> angles_deg = {0, 40, 90}, wavelengths_nm = {450, 620};

const FilmColumn& column(const FilmTable& table, std::string_view name) {
  for (const FilmColumn& candidate : table.columns)
    if (candidate.name == name) return candidate;
  ADD_FAILURE() << name;
  return table.columns.front();
}

TEST(FilmTable, HoldsTheReferenceRowByRow) {
  const auto table = film_table(mirror, optics::Interference::airy, angles_deg, wavelengths_nm, {true, true, true});
  ASSERT_TRUE(table.ok());
  ASSERT_EQ(table->rows(), 6u);
  EXPECT_EQ(table->columns.size(), film_table_columns(mirror, {true, true, true}));
  for (std::size_t a = 0; a < angles_deg.size(); ++a) {
    for (std::size_t w = 0; w < wavelengths_nm.size(); ++w) {
      const optics::Incidence incidence = optics::incidence_from(Degrees(angles_deg[a]));
      const std::size_t row = table->row(a, w);
      const optics::StackPowers all = optics::stack_powers(mirror, incidence, wavelengths_nm[w]);
      const optics::Powers powers = film_powers(mirror, optics::Interference::airy, incidence, wavelengths_nm[w]);
      const optics::Amplitudes at = optics::stack_amplitudes(mirror, incidence, wavelengths_nm[w]);
      EXPECT_EQ(column(*table, "R_p").values[row], powers.R_p);
      EXPECT_EQ(column(*table, "T_s").values[row], powers.T_s);
      EXPECT_EQ(column(*table, "A_s").values[row], 1 - powers.R_s - powers.T_s);
      EXPECT_EQ(column(*table, "A_p_1").values[row], all.A_p[0]);
      EXPECT_EQ(column(*table, "A_s_3").values[row], all.A_s[2]);
      EXPECT_EQ(column(*table, "r_p_im").values[row], at.r_p.imag());
      EXPECT_EQ(column(*table, "t_s_re").values[row], at.t_s.real());
      EXPECT_NEAR(column(*table, "r_s_deg").values[row], std::arg(at.r_s) * 180 / std::numbers::pi, 1e-12);
    }
  }
}

TEST(FilmTable, HasOnlyWhatIsAskedFor) {
  const auto table = film_table(mirror, optics::Interference::airy, angles_deg, wavelengths_nm);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table->columns.size(), 6u);
  EXPECT_EQ(film_table_columns(mirror, {}), 6u);
  EXPECT_EQ(film_table_columns(mirror, {.ellipsometry = true}), 10u);
}

TEST(FilmTable, RefusesWhatAModelDoesNotKnow) {
  const optics::Stack film = *optics::parse_stack("air | water 300nm | air");
  const optics::Stack window = *optics::parse_stack("air | MgF2 100nm | glass 1mm incoherent | air");
  const auto works = [&](const optics::Stack& stack, optics::Interference model, const FilmTableDetails& details) {
    return film_table(stack, model, angles_deg, wavelengths_nm, details).ok();
  };
  EXPECT_TRUE(works(film, optics::Interference::two_beam, {}));
  EXPECT_FALSE(works(film, optics::Interference::two_beam, {.layers = true}));
  EXPECT_FALSE(works(film, optics::Interference::none, {.amplitudes = true}));
  EXPECT_FALSE(works(mirror, optics::Interference::two_beam, {}));
  EXPECT_TRUE(works(window, optics::Interference::airy, {.layers = true}));
  EXPECT_FALSE(works(window, optics::Interference::airy, {.amplitudes = true}));
  EXPECT_FALSE(works(window, optics::Interference::airy, {.ellipsometry = true}));
}

}  // namespace
}  // namespace shabon::desk
