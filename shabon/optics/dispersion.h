// Dispersion formulas: the refractive index as a function of the wavelength, equation (37). The numbering is that of
// refractiveindex.info (Polyanskiy, "Dispersion formulas", refractiveindex.info/about).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::optics {

struct DispersionFormula {
  int number = 0;                    // of refractiveindex.info
  std::vector<double> coefficients;  // for wavelengths in micrometres

  // The refractive index at a vacuum wavelength in nm; NaN where the formula has no real value.
  double index(double wavelength_nm) const;

  friend bool operator==(const DispersionFormula&, const DispersionFormula&) = default;
};

struct DispersionFormulaEntry {
  int number;
  std::string_view name;
  std::string_view equation;  // with C1, C2, ... the coefficients and L the wavelength in micrometres
  std::string_view counts;    // how many coefficients it takes: "expected an odd number of coefficients ..."
  bool (*takes)(std::size_t count);
  double (*index)(std::span<const double> coefficients, double wavelength_um);
};

inline constexpr std::size_t most_coefficients = 99;

// The formulas that can be evaluated: one list.
extern const std::array<DispersionFormulaEntry, 9> dispersion_formulas;

// A formula with its coefficients. Errors: a number that is not in the list, coefficients that do not make up whole
// terms or are more than most_coefficients, a coefficient that is not finite.
Result<DispersionFormula> dispersion_formula(int number, std::vector<double> coefficients);

}  // namespace shabon::optics
