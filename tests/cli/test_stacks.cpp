// spectrum for stacks of any kind: what it prints against independent programs, and the columns on request.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "child.h"
#include "printed.h"
#include "shabon/base/text.h"

namespace shabon::test {
namespace {

std::vector<double> list(const std::string& text) {
  std::vector<double> values;
  for (const std::string_view part : split(text, ';'))
    if (!part.empty()) values.push_back(parse_number(part).value_or(NAN));
  return values;
}

// The expression of a record of tests/data/optics/b_stacks_*.csv; `kinds` has 'i' for each incoherent medium.
std::string expression_of(const io::CsvTable& table, std::size_t row) {
  const auto cell = [&](std::string_view name) {
    const auto column = table.column(name);
    return column ? std::string(table.rows[row].cells[*column].text) : std::string();
  };
  const std::vector<double> n = list(cell("n_re")), k = list(cell("n_im")), thickness_nm = list(cell("d_nm"));
  const std::string kinds = cell("coh");
  std::string text;
  for (std::size_t i = 0; i < n.size(); ++i) {
    text += (i ? " | " : "") + format_number(n[i]) + "+" + format_number(k[i]) + "i";
    if (i == 0 || i + 1 == n.size()) continue;
    text += " " + format_number(thickness_nm[i - 1]) + "nm";
    if (!kinds.empty() && kinds[i] == 'i') text += " incoherent";
  }
  return text;
}

// Compares columns of the program (first) with those of the file (second) for every `step`th record.
void compare(const std::string& file, std::size_t step, const std::vector<std::string>& flags,
             const std::vector<std::pair<std::string, std::string>>& columns, double tolerance) {
  const Result<io::CsvTable> table = io::read_csv(SHABON_TEST_DATA "/optics/" + file);
  ASSERT_TRUE(table.ok());
  const auto angle_deg = column(*table, "theta_deg"), wavelength_nm = column(*table, "lambda_nm");
  ASSERT_GT(table->rows.size(), step);
  for (std::size_t i = 0; i < table->rows.size(); i += step) {
    std::vector<std::string> arguments = {"spectrum",      expression_of(*table, i),
                                          "--angle",       format_number(angle_deg[i]),
                                          "--wavelengths", format_number(wavelength_nm[i])};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const io::CsvTable printed = table_of(arguments);
    for (const auto& [ours, theirs] : columns)
      EXPECT_NEAR(column(printed, ours).at(0), column(*table, theirs)[i], tolerance) << arguments[1] << " " << ours;
  }
}

TEST(Stacks, CoherentOnesAgreeWithAnIndependentProgram) {
  compare("b_stacks_coherent.csv", 17, {"--amplitudes"},
          {{"R_s", "R_s"},
           {"R_p", "R_p"},
           {"T_s", "T_s"},
           {"T_p", "T_p"},
           {"r_s_re", "rs_re"},
           {"r_s_im", "rs_im"},
           {"r_p_re", "rp_re"},
           {"r_p_im", "rp_im"}},
          1e-10);
}

TEST(Stacks, IncoherentOnesAgreeWithAnIndependentProgram) {
  compare("b_stacks_incoherent.csv", 5, {}, {{"R_s", "R_s"}, {"R_p", "R_p"}, {"T_s", "T_s"}, {"T_p", "T_p"}}, 1e-9);
}

const std::string mirror = "air | Ag 30nm | SiO2 120nm | 1.8+0.05i 40nm | 1.5";

TEST(Stacks, LayersAbsorbWhatIsNeitherReflectedNorTransmitted) {
  const std::vector<std::string> arguments = {"spectrum", mirror, "--angle", "50", "--wavelengths", "400:700:50"};
  std::vector<std::string> with_layers = arguments;
  with_layers.push_back("--layers");
  const io::CsvTable table = table_of(with_layers), plain = table_of(arguments);
  for (const char* polarisation : {"s", "p"}) {
    const auto of = [&](const std::string& name) { return column(table, name + "_" + polarisation); };
    const auto layer = [&](int j) { return column(table, std::string("A_") + polarisation + "_" + std::to_string(j)); };
    EXPECT_EQ(of("R"), column(plain, std::string("R_") + polarisation));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      EXPECT_NEAR(layer(1)[i] + layer(2)[i] + layer(3)[i], of("A")[i], 1e-12);
      EXPECT_GT(layer(1)[i], 0.001);
      EXPECT_EQ(layer(2)[i], 0);
      EXPECT_GT(layer(3)[i], 0.001);
    }
  }
  EXPECT_EQ(table.column("A_s_4"), std::nullopt);
}

TEST(Stacks, LightComesFromEitherSide) {
  const std::vector<std::string> grid = {"--wavelengths", "400:700:50", "--layers", "--amplitudes", "--ellipsometry"};
  std::vector<std::string> reversed = {"spectrum", mirror, "--reverse"};
  std::vector<std::string> written = {"spectrum", "1.5 | 1.8+0.05i 40nm | SiO2 120nm | Ag 30nm | air"};
  reversed.insert(reversed.end(), grid.begin(), grid.end());
  written.insert(written.end(), grid.begin(), grid.end());
  EXPECT_EQ(result_of(reversed), result_of(written));
  std::vector<std::string> front = written;
  front[1] = mirror;
  const io::CsvTable from_front = table_of(front), from_back = table_of(reversed);
  for (std::size_t i = 0; i < from_front.rows.size(); ++i) {
    EXPECT_NEAR(column(from_front, "T_s")[i], column(from_back, "T_s")[i], 1e-14);  // reciprocity
    EXPECT_GT(std::abs(column(from_front, "R_s")[i] - column(from_back, "R_s")[i]), 1e-3);
  }
}

TEST(Stacks, TellPhasesAndEllipsometry) {
  const io::CsvTable table =
      table_of({"spectrum", "1 | 1.5", "--angle", "0,30,80", "--wavelengths", "500", "--ellipsometry", "--amplitudes"});
  const auto value = [&](const char* name, std::size_t row) { return column(table, name).at(row); };
  // Below Brewster's angle r_p = -r_s in sign, above it both have one sign.
  EXPECT_NEAR(value("r_s_re", 0), -0.2, 1e-15);
  EXPECT_NEAR(value("r_p_re", 0), 0.2, 1e-15);
  EXPECT_NEAR(value("psi_deg", 0), 45, 1e-12);
  EXPECT_NEAR(value("delta_deg", 0), 180, 1e-12);
  EXPECT_NEAR(value("delta_deg", 1), 180, 1e-12);
  EXPECT_NEAR(value("delta_deg", 2), 0, 1e-12);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_NEAR(std::abs(value("r_s_deg", row)), 180, 1e-12);
    EXPECT_NEAR(std::tan(value("psi_deg", row) * std::numbers::pi / 180),
                std::abs(value("r_p_re", row) / value("r_s_re", row)), 1e-12);
  }
}

TEST(Stacks, FormsHaveTheSameColumns) {
  const std::vector<std::string> arguments = {"spectrum", mirror,           "--angle",      "0,60",     "--wavelengths",
                                              "500,600",  "--ellipsometry", "--amplitudes", "--layers", "--format"};
  const auto as = [&](const char* format) {
    std::vector<std::string> all = arguments;
    all.emplace_back(format);
    return all;
  };
  const io::CsvTable csv = table_of(as("csv"));
  EXPECT_EQ(csv.columns.size(), 2u + 6 + 12 + 4 + 6);
  const io::YamlDocument json = json_of(as("json"));
  const std::string text = result_of(as("text")), svg = result_of(as("svg"));
  for (const std::string& name : csv.columns) {
    EXPECT_EQ(numbers(json.root, name), column(csv, name)) << name;
    EXPECT_NE(text.find(" " + name), std::string::npos) << name;
  }
  for (const char* heading : {"R, reflected", "r_re", "psi", "60\u00B0"})
    EXPECT_NE(svg.find(heading), std::string::npos) << heading;
}

TEST(Stacks, SayWhatTheModelsDoNotKnow) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
      {{"air | water 1um | glass 1mm incoherent | air", "--amplitudes"}, "no amplitudes, only powers"},
      {{"air | glass 1mm incoherent | air", "--ellipsometry"}, "no psi and delta, only powers"},
      {{"air | water 1um | air", "--interference", "none", "--layers"}, "airy, the exact model, does"},
      {{"air | water 1um | 1.4 1um | air", "--interference", "two-beam"}, "use airy"},
      {{"air | ((water 1um | 1.4 1um)^100)^100 | air"}, "10000"},
  };
  for (const auto& [arguments, message] : refused) {
    std::vector<std::string> all = {"spectrum"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.exit_code, 3) << arguments[0];
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace shabon::test
