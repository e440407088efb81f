// Colours of films on substrates against an independent chain: tmm for the spectra, colour-science for the colours,
// from the same sources of n and k (the head of the file names versions and conventions).
#include <gtest/gtest.h>

#include <map>

#include "shabon/color/rgb.h"
#include "shabon/desk/film_color.h"
#include "shabon/desk/sweep.h"
#include "shabon/io/csv.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

struct System {
  const char *name, *stack;
  double tolerance;  // of X, Y, Z and linear sRGB
};

// Where both media are tables the indices are the same numbers. The file has silica and water as tables too, read
// between their rows on straight lines, where the library evaluates the formulas.
constexpr System systems[] = {
    {"SiO2/Si", "air | SiO2 1nm | Si", 2e-7},
    {"TiO2/Ti", "air | TiO2 1nm | Ti", 1e-9},
    {"Oil/H2O", "air | biodiesel 1nm | water", 2e-7},
    {"Fe3O4/Fe", "air | Fe3O4 1nm | Fe", 1e-9},
};

struct Row {
  double thickness_nm;
  color::Xyz xyz;
  color::LinearRgb linear;
};

std::map<std::string, std::vector<Row>> rows_by_system() {
  const Result<io::CsvTable> table = io::read_csv(SHABON_TEST_DATA "/color/films_on_substrates_d65.csv");
  std::map<std::string, std::vector<Row>> rows;
  if (!table) return rows;
  const auto column = [&](std::string_view name) { return *io::numbers(*table, name); };
  const auto d = column("d_nm"), x = column("X"), y = column("Y"), z = column("Z");
  const auto r = column("linDR"), g = column("linDG"), b = column("linDB"), theta = column("theta_deg");
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_EQ(theta[i], 0);
    rows[std::string(table->rows[i].cells[0].text)].push_back({d[i], {x[i], y[i], z[i]}, {r[i], g[i], b[i]}});
  }
  return rows;
}

TEST(FilmsOnSubstrates, AgreeWithAnIndependentProgram) {
  const auto rows = rows_by_system();
  ASSERT_EQ(rows.size(), std::size(systems));
  for (const System& system : systems) {
    const std::vector<Row>& expected = rows.at(system.name);
    ASSERT_GT(expected.size(), 10u);
    Sweep sweep{*optics::parse_stack(system.stack), 0, {}};
    for (const Row& row : expected) sweep.thicknesses_nm.push_back(row.thickness_nm);
    const auto swept = swept_colors(sweep, color::illuminants()[0]);
    ASSERT_TRUE(swept.ok());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      SCOPED_TRACE(testing::Message() << system.name << " " << expected[i].thickness_nm << " nm");
      sweep.stack.layers[0].thickness_nm = expected[i].thickness_nm;
      const Color single = color_of(unpolarised(sweep.stack, sweep.interference, sweep.incidence, Side::reflected),
                                    color::illuminants()[0]);
      for (const color::Xyz& xyz : {(*swept)[i], single.xyz}) {
        EXPECT_NEAR(xyz.x, expected[i].xyz.x, system.tolerance);
        EXPECT_NEAR(xyz.y, expected[i].xyz.y, system.tolerance);
        EXPECT_NEAR(xyz.z, expected[i].xyz.z, system.tolerance);
      }
      EXPECT_NEAR(single.linear_srgb.r, expected[i].linear.r, 4 * system.tolerance);
      EXPECT_NEAR(single.linear_srgb.g, expected[i].linear.g, 4 * system.tolerance);
      EXPECT_NEAR(single.linear_srgb.b, expected[i].linear.b, 4 * system.tolerance);
    }
  }
}

}  // namespace
}  // namespace shabon::desk
