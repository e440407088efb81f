// Every formula against its equation written out again, with numbers of its own.
#include "shabon/optics/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace shabon::optics {
namespace {

struct FormulaCase {
  int number;
  std::vector<double> coefficients;
  double (*expected)(double um);  // with the coefficients written in
};

double n_of(double n2) { return std::sqrt(n2); }

const FormulaCase formula_cases[] = {
    {1,
     {0.1, 1.2, 0.1, 0.3, 9},
     [](double L) { return n_of(1.1 + 1.2 * L * L / (L * L - 0.01) + 0.3 * L * L / (L * L - 81)); }},
    {2,
     {0.1, 1.2, 0.01, 0.3, 81},
     [](double L) { return n_of(1.1 + 1.2 * L * L / (L * L - 0.01) + 0.3 * L * L / (L * L - 81)); }},
    {3,
     {2.1, -0.01, 2, 0.02, -2, 1e-4, -4},
     [](double L) { return n_of(2.1 - 0.01 * L * L + 0.02 / (L * L) + 1e-4 / (L * L * L * L)); }},
    {3, {2.25}, [](double) { return 1.5; }},
    {4,
     {5.9, 0.24, 0, 0.08, 1, 0.5, 2, 9, 2, -0.03, 2, 0.002, -1, 1e-3, -4, 2e-3, 1},
     [](double L) {
       return n_of(5.9 + 0.24 / (L * L - 0.08) + 0.5 * L * L / (L * L - 81) - 0.03 * L * L + 0.002 / L +
                   1e-3 / (L * L * L * L) + 2e-3 * L);
     }},
    {4, {5.9, 0.24, 0, 0.08, 1}, [](double L) { return n_of(5.9 + 0.24 / (L * L - 0.08)); }},
    // Terms of weight 0 are no terms, not even at their poles: 0^0 = 1.
    {4, {4, 0, 0, 0, 0, 0, 0, 0.25, 1}, [](double) { return 2.0; }},
    {5,
     {1.45, 0.006, -2, -0.0004, -4, 0.001, 1},
     [](double L) { return 1.45 + 0.006 / (L * L) - 0.0004 / (L * L * L * L) + 0.001 * L; }},
    {6,
     {1e-6, 0.058, 238, 0.0017, 57.4},
     [](double L) { return 1 + 1e-6 + 0.058 / (238 - 1 / (L * L)) + 0.0017 / (57.4 - 1 / (L * L)); }},
    {7,
     {3.4, 0.16, -0.12, 1e-3, -2e-4, 3e-5},
     [](double L) {
       const double m = 1 / (L * L - 0.028);
       return 3.4 + 0.16 * m - 0.12 * m * m + 1e-3 * L * L - 2e-4 * L * L * L * L + 3e-5 * std::pow(L, 6);
     }},
    {7, {3.4, 0.16}, [](double L) { return 3.4 + 0.16 / (L * L - 0.028); }},
    {8,
     {0.2, 0.05, 0.03, -0.002},
     [](double L) {
       const double a = 0.2 + 0.05 * L * L / (L * L - 0.03) - 0.002 * L * L;
       return n_of((1 + 2 * a) / (1 - a));
     }},
    {9,
     {2.5, 0.02, 0.03, 0.01, 0.25, 0.04},
     [](double L) { return n_of(2.5 + 0.02 / (L * L - 0.03) + 0.01 * (L - 0.25) / ((L - 0.25) * (L - 0.25) + 0.04)); }},
};

TEST(Dispersion, EveryFormulaFollowsItsEquation) {
  std::set<int> tested;
  for (const FormulaCase& one : formula_cases) {
    const Result<DispersionFormula> formula = dispersion_formula(one.number, one.coefficients);
    ASSERT_TRUE(formula.ok()) << one.number;
    for (double nm = 300; nm <= 2000; nm += 12.5)
      EXPECT_NEAR(formula->index(nm), one.expected(nm / 1000), 1e-13) << one.number << " at " << nm;
    tested.insert(one.number);
  }
  for (const DispersionFormulaEntry& entry : dispersion_formulas)
    EXPECT_TRUE(tested.count(entry.number)) << entry.number;
}

// What the list says of the number of coefficients is what it takes.
TEST(Dispersion, RefusesWhatItCannotEvaluate) {
  for (const DispersionFormulaEntry& entry : dispersion_formulas) {
    for (std::size_t count = 0; count < 110; ++count) {
      const Result<DispersionFormula> formula = dispersion_formula(entry.number, std::vector<double>(count, 0.1));
      EXPECT_EQ(formula.ok(), entry.takes(count));
      if (formula) continue;
      EXPECT_EQ(formula.errors()[0].message.rfind("expected " + std::string(entry.counts), 0), 0u) << count;
    }
    EXPECT_FALSE(entry.takes(0));
    EXPECT_FALSE(entry.takes(100));
  }
  for (const int number : {-1, 0, 10, 77}) {
    EXPECT_EQ(dispersion_formula(number, {1}).errors()[0].message,
              "expected a dispersion formula of number 1..9, got " + std::to_string(number));
    EXPECT_TRUE(std::isnan((DispersionFormula{number, {1}}.index(500))));
  }
  EXPECT_FALSE(dispersion_formula(2, {0, 1, std::nan("")}).ok());
  EXPECT_TRUE(std::isnan((DispersionFormula{2, {}}.index(500))));
}

}  // namespace
}  // namespace shabon::optics
