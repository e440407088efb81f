#include "shabon/optics/dispersion.h"

#include <cmath>
#include <string>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

// n^2 = 1 + C1 + sum C_j L^2/(L^2 - pole_j), in both forms of the Sellmeier equation.
template <class Pole>
double sellmeier(const std::vector<double>& coefficients, double wavelength_um, Pole pole_um2) {
  const double square_um2 = wavelength_um * wavelength_um;
  double n2 = 1 + coefficients[0];
  for (std::size_t j = 1; j + 1 < coefficients.size(); j += 2)
    n2 += coefficients[j] * square_um2 / (square_um2 - pole_um2(coefficients[j + 1]));
  return std::sqrt(n2);
}

double sellmeier_by_resonance(const std::vector<double>& coefficients, double wavelength_um) {
  return sellmeier(coefficients, wavelength_um, [](double resonance_um) { return resonance_um * resonance_um; });
}

double sellmeier_by_square(const std::vector<double>& coefficients, double wavelength_um) {
  return sellmeier(coefficients, wavelength_um, [](double square_um2) { return square_um2; });
}

const DispersionFormulaEntry* find_formula(int number) {
  for (const DispersionFormulaEntry& entry : dispersion_formulas)
    if (entry.number == number) return &entry;
  return nullptr;
}

}  // namespace

const std::array<DispersionFormulaEntry, 2> dispersion_formulas = {{
    {1, "Sellmeier", "n^2 - 1 = C1 + C2 L^2/(L^2 - C3^2) + C4 L^2/(L^2 - C5^2) + ...", sellmeier_by_resonance},
    {2, "Sellmeier-2", "n^2 - 1 = C1 + C2 L^2/(L^2 - C3) + C4 L^2/(L^2 - C5) + ...", sellmeier_by_square},
}};

double DispersionFormula::index(double wavelength_nm) const {
  const DispersionFormulaEntry* entry = find_formula(number);
  return entry && !coefficients.empty() ? entry->index(coefficients, wavelength_nm / 1000) : std::nan("");
}

Result<DispersionFormula> dispersion_formula(int number, std::vector<double> coefficients) {
  if (!find_formula(number)) {
    std::string known;
    for (const DispersionFormulaEntry& entry : dispersion_formulas)
      known += (known.empty() ? "" : ", ") + std::to_string(entry.number);
    return fail(Failure::content,
                "expected a dispersion formula of number " + known + ", got " + std::to_string(number));
  }
  if (coefficients.size() % 2 == 0)
    return fail(Failure::content,
                "expected an odd number of coefficients (C1, then pairs), got " + std::to_string(coefficients.size()));
  for (double coefficient : coefficients)
    if (!std::isfinite(coefficient)) return fail(Failure::content, "expected finite coefficients");
  return DispersionFormula{number, std::move(coefficients)};
}

}  // namespace shabon::optics
