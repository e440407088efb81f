#include "shabon/optics/dispersion.h"

#include <cmath>
#include <string>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

using Coefficients = std::span<const double>;

double square(double x) { return x * x; }

// The sum of term(C_j, C_j+1) over the pairs that follow C1. A term without weight is left out, whatever its pole.
template <class Term>
double sum_of_pairs(Coefficients c, Term term) {
  double sum = 0;
  for (std::size_t j = 1; j + 1 < c.size(); j += 2)
    if (c[j] != 0) sum += term(c[j], c[j + 1]);
  return sum;
}

double sellmeier(Coefficients c, double um) {
  const double um2 = square(um);
  return std::sqrt(1 + c[0] + sum_of_pairs(c, [&](double weight, double resonance_um) {
                     return weight * um2 / (um2 - square(resonance_um));
                   }));
}

double sellmeier_2(Coefficients c, double um) {
  const double um2 = square(um);
  return std::sqrt(1 + c[0] + sum_of_pairs(c, [&](double weight, double resonance_um2) {
                     return weight * um2 / (um2 - resonance_um2);
                   }));
}

double power_series(Coefficients c, double um) {
  return c[0] + sum_of_pairs(c, [&](double weight, double exponent) { return weight * std::pow(um, exponent); });
}

double polynomial(Coefficients c, double um) { return std::sqrt(power_series(c, um)); }

// Two resonances of four coefficients each, then powers.
double refractiveindex_info(Coefficients c, double um) {
  constexpr std::size_t first_power = 9;
  double n2 = c[0];
  for (std::size_t j = 1; j + 3 < c.size() && j < first_power; j += 4)
    if (c[j] != 0) n2 += c[j] * std::pow(um, c[j + 1]) / (square(um) - std::pow(c[j + 2], c[j + 3]));
  for (std::size_t j = first_power; j + 1 < c.size(); j += 2)
    if (c[j] != 0) n2 += c[j] * std::pow(um, c[j + 1]);
  return std::sqrt(n2);
}

double gases(Coefficients c, double um) {
  const double inverse_um2 = 1 / square(um);
  return 1 + c[0] +
         sum_of_pairs(c, [&](double weight, double pole_per_um2) { return weight / (pole_per_um2 - inverse_um2); });
}

// Herzberger, Colour correction in optical systems and a new dispersion formula, Opt. Acta 6, 197 (1959).
double herzberger(Coefficients c, double um) {
  constexpr double pole_um2 = 0.028;
  const double um2 = square(um), resonance = 1 / (um2 - pole_um2);
  const std::array<double, 6> terms = {1, resonance, square(resonance), um2, square(um2), square(um2) * um2};
  double n = 0;
  for (std::size_t i = 0; i < c.size(); ++i) n += c[i] * terms[i];
  return n;
}

double retro(Coefficients c, double um) {
  const double um2 = square(um);
  const double resonance = c[1] == 0 ? 0 : c[1] * um2 / (um2 - c[2]);
  const double polarisability = c[0] + resonance + c[3] * um2;
  return std::sqrt((1 + 2 * polarisability) / (1 - polarisability));
}

double exotic(Coefficients c, double um) {
  const double resonance = c[1] == 0 ? 0 : c[1] / (square(um) - c[2]);
  const double line = c[3] == 0 ? 0 : c[3] * (um - c[4]) / (square(um - c[4]) + c[5]);
  return std::sqrt(c[0] + resonance + line);
}

bool takes_pairs(std::size_t count) { return count % 2 == 1 && count <= most_coefficients; }
bool takes_quadruples(std::size_t count) {
  return count == 1 || count == 5 || (count % 2 == 1 && count >= 9 && count <= 17);
}
bool takes_up_to_six(std::size_t count) { return count >= 1 && count <= 6; }
bool takes_six(std::size_t count) { return count == 6; }
bool takes_four(std::size_t count) { return count == 4; }

constexpr std::string_view pairs = "an odd number of coefficients up to 99 (C1, then pairs)";
constexpr std::string_view quadruples = "1, 5, 9, 11, 13, 15 or 17 coefficients";

const DispersionFormulaEntry* find_formula(int number) {
  for (const DispersionFormulaEntry& entry : dispersion_formulas)
    if (entry.number == number) return &entry;
  return nullptr;
}

}  // namespace

const std::array<DispersionFormulaEntry, 9> dispersion_formulas = {{
    {1, "Sellmeier", "n^2 - 1 = C1 + C2 L^2/(L^2 - C3^2) + C4 L^2/(L^2 - C5^2) + ...", pairs, takes_pairs, sellmeier},
    {2, "Sellmeier-2", "n^2 - 1 = C1 + C2 L^2/(L^2 - C3) + C4 L^2/(L^2 - C5) + ...", pairs, takes_pairs, sellmeier_2},
    {3, "Polynomial", "n^2 = C1 + C2 L^C3 + C4 L^C5 + ...", pairs, takes_pairs, polynomial},
    {4, "RefractiveIndex.INFO",
     "n^2 = C1 + C2 L^C3/(L^2 - C4^C5) + C6 L^C7/(L^2 - C8^C9) + C10 L^C11 + ... + C16 L^C17", quadruples,
     takes_quadruples, refractiveindex_info},
    {5, "Cauchy", "n = C1 + C2 L^C3 + C4 L^C5 + ...", pairs, takes_pairs, power_series},
    {6, "Gases", "n - 1 = C1 + C2/(C3 - L^-2) + C4/(C5 - L^-2) + ...", pairs, takes_pairs, gases},
    {7, "Herzberger", "n = C1 + C2/(L^2 - 0.028) + C3/(L^2 - 0.028)^2 + C4 L^2 + C5 L^4 + C6 L^6", "1..6 coefficients",
     takes_up_to_six, herzberger},
    {8, "Retro", "(n^2 - 1)/(n^2 + 2) = C1 + C2 L^2/(L^2 - C3) + C4 L^2", "4 coefficients", takes_four, retro},
    {9, "Exotic", "n^2 = C1 + C2/(L^2 - C3) + C4 (L - C5)/((L - C5)^2 + C6)", "6 coefficients", takes_six, exotic},
}};

double DispersionFormula::index(double wavelength_nm) const {
  const DispersionFormulaEntry* entry = find_formula(number);
  return entry && entry->takes(coefficients.size()) ? entry->index(coefficients, wavelength_nm / 1000) : std::nan("");
}

Result<DispersionFormula> dispersion_formula(int number, std::vector<double> coefficients) {
  const DispersionFormulaEntry* entry = find_formula(number);
  if (!entry)
    return fail(Failure::content,
                "expected a dispersion formula of number " + std::to_string(dispersion_formulas.front().number) + ".." +
                    std::to_string(dispersion_formulas.back().number) + ", got " + std::to_string(number));
  if (!entry->takes(coefficients.size()))
    return fail(Failure::content, "expected " + std::string(entry->counts) + " for formula " + std::to_string(number) +
                                      ", got " + std::to_string(coefficients.size()));
  for (double coefficient : coefficients)
    if (!std::isfinite(coefficient)) return fail(Failure::content, "expected finite coefficients");
  return DispersionFormula{number, std::move(coefficients)};
}

}  // namespace shabon::optics
