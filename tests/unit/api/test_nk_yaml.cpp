#include <cmath>
#include <complex>
#include <set>

#include "nk_case.h"

namespace shabon::api {
namespace {

using Complex = std::complex<double>;

struct FormulaFile {
  int number;
  const char* coefficients;
  double (*expected)(double um);  // the equation written out again
};

double square(double x) { return x * x; }

const FormulaFile formula_files[] = {
    {1, "0.1 1.2 0.1", [](double L) { return std::sqrt(1.1 + 1.2 * L * L / (L * L - 0.01)); }},
    {2, "0 1.0057 0.013217", [](double L) { return std::sqrt(1 + 1.0057 * L * L / (L * L - 0.013217)); }},
    {3, "2.16 0.0005 2 0.02 -2", [](double L) { return std::sqrt(2.16 + 0.0005 * L * L + 0.02 / (L * L)); }},
    {4, "5.913 0.2441 0 0.0803 1 0 0 0 1", [](double L) { return std::sqrt(5.913 + 0.2441 / (L * L - 0.0803)); }},
    {5, "1.513 -0.003169 2 0.003962 -2", [](double L) { return 1.513 - 0.003169 * L * L + 0.003962 / (L * L); }},
    {6, "0 0.05792105 238.0185 0.00167917 57.362",
     [](double L) { return 1 + 0.05792105 / (238.0185 - 1 / (L * L)) + 0.00167917 / (57.362 - 1 / (L * L)); }},
    {7, "1.5 0.01 -0.001 1e-3 0 0",
     [](double L) { return 1.5 + 0.01 / (L * L - 0.028) - 0.001 / square(L * L - 0.028) + 1e-3 * L * L; }},
    {8, "0.25 0.05 0.03 -0.01",
     [](double L) {
       const double a = 0.25 + 0.05 * L * L / (L * L - 0.03) - 0.01 * L * L;
       return std::sqrt((1 + 2 * a) / (1 - a));
     }},
    {9, "2.5 0.02 0.03 0.01 0.25 0.04",
     [](double L) { return std::sqrt(2.5 + 0.02 / (L * L - 0.03) + 0.01 * (L - 0.25) / (square(L - 0.25) + 0.04)); }},
};

// As that database writes it, with keys of several of its versions that say nothing about n and k.
std::string formula_text(const FormulaFile& file) {
  return "# a comment\nREFERENCES: |\n    A. Author, <i>Journal</i>\nCOMMENTS: none\nDATA:\n  - type: formula " +
         std::to_string(file.number) + "\n    wavelength_range: 0.4 0.7\n    coefficients: " + file.coefficients +
         "\nCONDITIONS:\n    temperature: 293\nSPECS:\n    n_is_absolute: true\n    nd: 1.5\nPROPERTIES: {Vd: 60}\n";
}

TEST(NkYaml, EveryFormula) {
  const NkFolder folder;
  std::set<int> read;
  for (const FormulaFile& file : formula_files) {
    const auto medium = folder.read("a.yml", formula_text(file));
    ASSERT_TRUE(medium.ok()) << file.number << to_text(medium.errors());
    for (double nm = 360; nm <= 830; nm += 5)
      EXPECT_NEAR(medium->index(nm).real(), file.expected(nm / 1000), 1e-12) << file.number << " at " << nm;
    EXPECT_EQ(medium->range_nm(), (optics::WavelengthRange{400, 700}));
    EXPECT_TRUE(medium->is_lossless());
    EXPECT_EQ(medium->source(), "A. Author, <i>Journal</i>");
    read.insert(file.number);
  }
  for (const optics::DispersionFormulaEntry& entry : optics::dispersion_formulas)
    EXPECT_EQ(read.count(entry.number), 1u);
}

TEST(NkYaml, Tables) {
  const NkFolder folder;
  const auto nk =
      folder.read("a.yaml", "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n        0.6 1.7 0.2\n");
  ASSERT_TRUE(nk.ok()) << to_text(nk.errors());
  EXPECT_NEAR(std::abs(nk->index(500) - Complex(1.6, 0.1)), 0, 1e-14);

  const auto n = folder.read("a.yml", "DATA: [{type: Tabulated N, data: \"0.4 1.5\\n0.6 1.7\"}]\n");
  ASSERT_TRUE(n.ok()) << to_text(n.errors());
  EXPECT_NEAR(n->index(500).real(), 1.6, 1e-14);
  EXPECT_TRUE(n->is_lossless());
}

// n and k of different wavelengths: straight lines of their own, whatever the other one's rows.
TEST(NkYaml, SeparateTablesOfNAndK) {
  const NkFolder folder;
  const auto medium =
      folder.read("a.yml",
                  "DATA:\n"
                  "  - type: tabulated k\n    data: |\n        0.45 0.1\n        0.5 0.3\n        0.8 0.0\n"
                  "  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.6 1.7\n        0.7 1.1\n");
  ASSERT_TRUE(medium.ok()) << to_text(medium.errors());
  EXPECT_NEAR(std::abs(medium->index(475) - Complex(1.575, 0.2)), 0, 1e-14);
  EXPECT_NEAR(std::abs(medium->index(650) - Complex(1.4, 0.15)), 0, 1e-14);
  EXPECT_NEAR(std::abs(medium->index(420) - Complex(1.52, 0.1)), 0, 1e-14);
  EXPECT_NEAR(std::abs(medium->index(750) - Complex(1.1, 0.05)), 0, 1e-14);
  EXPECT_EQ(medium->range_nm(), (optics::WavelengthRange{450, 700}));
  EXPECT_EQ(medium->outside_range_note(optics::WavelengthRange{420, 600}),
            "a.yml: its source covers 450..700 nm; below, one of n and k is known, the end value of the other is held");
}

TEST(NkYaml, FormulaForNAndTableForK) {
  const NkFolder folder;
  const auto medium =
      folder.read("a.yml",
                  "DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.9\n    coefficients: 1.5 0.01 -2\n"
                  "  - type: tabulated k\n    data: |\n        0.5 1e-3\n        0.7 3e-3\n");
  ASSERT_TRUE(medium.ok()) << to_text(medium.errors());
  for (double nm = 360; nm <= 830; nm += 5) EXPECT_NEAR(medium->index(nm).real(), 1.5 + 1e4 / (nm * nm), 1e-14);
  EXPECT_NEAR(medium->index(600).imag(), 2e-3, 1e-15);
  EXPECT_EQ(medium->index(400).imag(), 1e-3);
  EXPECT_EQ(medium->index(1200).imag(), 3e-3);
  EXPECT_EQ(medium->range_nm(), (optics::WavelengthRange{500, 700}));
}

TEST(NkYaml, ProblemsHaveAPlace) {
  const NkFolder folder;
  const BrokenFile broken[] = {
      {"DATA:\n  - type: tabulated n\n    data: |\n      400 1.50\n      700 1.49\n", 4, 7,
       "expected wavelengths in micrometres, got 400 as the shortest: are they nanometres?"},
      {"a: 1\n", 1, 1, "expected a list DATA as in a file of refractiveindex.info, got none"},
      {"[1, 2]\n", 1, 1, "expected a list DATA"},
      {"DATA: 3\n", 1, 7, "expected a list DATA as in a file of refractiveindex.info, got "},
      {"DATA: []\n", 1, 7, "expected a list DATA"},
      {"DATA:\n  - 3\n", 2, 5, "expected a mapping with a type, got "},
      {"DATA:\n  - data: 1 2\n", 2, 5, "expected a type: 'formula 1' .. 'formula 9', 'tabulated n',"},
      {"DATA:\n  - type: tabulated m\n    data: 1 2\n", 2, 11,
       "expected 'formula 1' .. 'formula 9', 'tabulated n', "
       "'tabulated k' or 'tabulated nk', got 'tabulated m'"},
      {"DATA:\n  - type: formula 10\n    wavelength_range: 0.4 0.7\n    coefficients: 1\n", 2, 11,
       "expected 'formula 1' .. 'formula 9', got 'formula 10'"},
      {"DATA:\n  - type: formula x\n    wavelength_range: 0.4 0.7\n    coefficients: 1\n", 2, 11,
       "expected 'formula 1'"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.4 0.7\n    coefficients: 0 1\n", 4, 19,
       "expected an odd number of coefficients up to 99 (C1, then pairs) for formula 2, got 2"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.4 0.7\n    coefficients: 0 1 y\n", 4, 23,
       "expected a number, got 'y'"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.7 0.4\n    coefficients: 0 1 0.01\n", 3, 23,
       "expected two rising wavelengths > 0, got '0.7 0.4'"},
      {"DATA:\n  - type: formula 2\n    coefficients: 0 1 0.01\n", 2, 5, "expected numbers as wavelength_range"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.4 0.7\n", 2, 5, "expected numbers as coefficients"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.4 0.7\n    coefficients: [0, 1, 2]\n", 4, 19,
       "expected numbers as coefficients, got a list"},
      {"DATA:\n  - type: formula 2\n    wavelength_range: 0.4 0.7\n    coefficients: 0 1 0.25\n", 4, 19,
       "expected a formula that gives a real index of 0.0001..10000 over its range, got none at 4"},
      {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 x1\n", 5, 13,
       "expected a number, got 'x1'"},
      {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.3 1.5\n", 5, 9,
       "expected rising wavelengths > 0, got 0.3 after 0.4"},
      {"DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n        0.5 1.5 -2\n", 5, 17,
       "expected n and k >= 0, got -2"},
      {"DATA:\n  - type: tabulated n\n    data: >-\n        0.4 1.5\n        0.5 \u00E9 \n", 5, 13,
       "expected a number"},
      {"DATA:\n  - {type: tabulated n, data: \"0.4 1.5 0.5 q\"}\n", 2, 44, "expected a number, got 'q'"},
      {"DATA:\n  - type: tabulated nk\n    data: 0.4 1.5\n", 3, 11,
       "expected rows of 3 numbers (the wavelength in micrometres, then nk), got 2 numbers"},
      {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5\n        0.6 1.5\n", 5, 9,
       "expected rows of 2 numbers (the wavelength in micrometres, then n), got 1 number"},
      {"DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n\n        0.5 1.5\n        0.6 1.5 0 1\n", 6, 9,
       "expected rows of 3 numbers (the wavelength in micrometres, then nk), got 2 numbers"},
      {"DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.5 0.1\n", 5, 9,
       "expected rows of 2 numbers (the wavelength in micrometres, then n), got 3 numbers"},
      {"DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n        0.5 0 0\n", 5, 13,
       "expected an index other than 0"},
      {"DATA:\n  - type: tabulated n\n    data: |\n", 3, 11, "expected rows of 2 numbers"},
      {"DATA:\n  - type: tabulated k\n    data: 0.4 1.5\n", 2, 3, "expected an entry that gives n"},
      {"DATA:\n  - type: tabulated n\n    data: 0.4 1.5\n  - type: tabulated nk\n    data: 0.4 1 1\n", 4, 11,
       "expected one entry that gives n, got a second one"},
      {"DATA:\n  - type: tabulated n\n    data: 0.4 1.5\n  - type: tabulated k\n    data: 0.5 1\n", 2, 3,
       "expected n and k at common wavelengths"},
      {"DATA:\n  - type: tabulated n\n    data: 0.4 0\n", 2, 3, "row 1: expected an index other than 0"},
  };
  for (const BrokenFile& one : broken) expect_refused(folder, "a.yml", one);
  EXPECT_EQ(read_nk_file("/nowhere/a.yml").errors().front().failure, Failure::file);
}

}  // namespace
}  // namespace shabon::api
