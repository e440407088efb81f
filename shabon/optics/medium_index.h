// The forms in which a medium's index is known. Only medium.cpp sees them.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::optics {

struct ConstantIndex {
  std::complex<double> index;
  friend bool operator==(const ConstantIndex&, const ConstantIndex&) = default;
};

// n by a formula and, where the medium absorbs, k by a table.
struct FormulaIndex {
  DispersionFormula formula;
  WavelengthRange range;      // that the source states for the formula
  WavelengthRange continued;  // over which the formula is used
  std::vector<AbsorptionSample> absorption;
  friend bool operator==(const FormulaIndex&, const FormulaIndex&) = default;
};

struct TableIndex {
  std::vector<IndexSample> rows;
  WavelengthRange range;  // that the source covers with n and k
  friend bool operator==(const TableIndex&, const TableIndex&) = default;
};

struct MixtureIndex {
  std::vector<MixturePart> parts;
  friend bool operator==(const MixtureIndex&, const MixtureIndex&) = default;
};

using MediumIndex = std::variant<ConstantIndex, FormulaIndex, TableIndex, MixtureIndex>;

Result<FormulaIndex> formula_index(DispersionFormula formula, WavelengthRange range,
                                   std::vector<AbsorptionSample> absorption);
Result<TableIndex> table_index(std::vector<IndexSample> rows, std::optional<WavelengthRange> range);
Result<MixtureIndex> mixture_index(std::vector<MixturePart> parts);

std::complex<double> index_at(const ConstantIndex& constant, double wavelength_nm);
std::complex<double> index_at(const FormulaIndex& formula, double wavelength_nm);
std::complex<double> index_at(const TableIndex& table, double wavelength_nm);
std::complex<double> index_at(const MixtureIndex& mixture, double wavelength_nm);

constexpr std::string_view form_of(const ConstantIndex&) { return "constant"; }
constexpr std::string_view form_of(const FormulaIndex&) { return "formula"; }
constexpr std::string_view form_of(const TableIndex&) { return "table"; }
constexpr std::string_view form_of(const MixtureIndex&) { return "mixture"; }

bool lossless(const ConstantIndex& constant);
bool lossless(const FormulaIndex& formula);
bool lossless(const TableIndex& table);
bool lossless(const MixtureIndex& mixture);

// The same n with k = 0.
ConstantIndex lossless_form(const ConstantIndex& constant);
FormulaIndex lossless_form(const FormulaIndex& formula);
TableIndex lossless_form(const TableIndex& table);
MixtureIndex lossless_form(const MixtureIndex& mixture);

// The wavelengths that the source covers; nothing when there is no bound.
std::optional<WavelengthRange> range_of(const ConstantIndex& constant);
std::optional<WavelengthRange> range_of(const FormulaIndex& formula);
std::optional<WavelengthRange> range_of(const TableIndex& table);
std::optional<WavelengthRange> range_of(const MixtureIndex& mixture);

}  // namespace shabon::optics
