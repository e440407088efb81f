#include "shabon/optics/medium_index.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/optics/mixing.h"

namespace shabon::optics {

namespace {

// Beyond its range a formula is continued in steps of this width, as long as it behaves.
constexpr double continuation_step_nm = 1;
// A steeper formula runs into a resonance, where a sum of poles says nothing any more. Rutile reaches 0.015 at 360 nm.
constexpr double steepest_per_nm = 0.05;
constexpr int range_samples = 4096;  // at which a formula is checked
constexpr double most_sum_error = 1e-6;

constexpr const char* no_common = "expected n and k at common wavelengths";

bool is_index(double n) { return n >= smallest_index && n <= largest_index; }

// How far the formula can be used from `from_nm` towards `to_nm`.
double continued_to(const DispersionFormula& formula, double from_nm, double to_nm) {
  const double step = to_nm < from_nm ? -continuation_step_nm : continuation_step_nm;
  double reached_nm = from_nm, n = formula.index(from_nm);
  while (reached_nm != to_nm) {
    const double next_nm = std::abs(to_nm - reached_nm) <= continuation_step_nm ? to_nm : reached_nm + step;
    const double next_n = formula.index(next_nm);
    if (!is_index(next_n) || !(std::abs(next_n - n) <= steepest_per_nm * std::abs(next_nm - reached_nm))) break;
    reached_nm = next_nm;
    n = next_n;
  }
  return reached_nm;
}

// What is wrong with a wavelength that follows `previous_nm`; empty when nothing is.
std::string wavelength_problem(double wavelength_nm, double previous_nm) {
  if (wavelength_nm <= 0) return "expected a wavelength > 0 nm, got " + format_number(wavelength_nm);
  if (wavelength_nm <= previous_nm)
    return "expected rising wavelengths, got " + format_number(wavelength_nm) + " nm after " +
           format_number(previous_nm) + " nm";
  return {};
}

std::string problem(const IndexSample& row) {
  if (!std::isfinite(row.wavelength_nm) || !std::isfinite(row.n) || !std::isfinite(row.k))
    return "expected finite numbers";
  if (row.n < 0) return "expected n >= 0, got " + format_number(row.n);
  if (row.k < 0) return "expected k >= 0 (n + ik absorbs), got " + format_number(row.k);
  if (row.n == 0 && row.k == 0) return "expected an index other than 0";
  if (std::max(row.n, row.k) > largest_index)
    return "expected n and k of at most " + format_number(largest_index) + ", got " +
           format_number(std::max(row.n, row.k));
  return {};
}

std::string problem(const AbsorptionSample& row) { return problem(IndexSample{row.wavelength_nm, 1, row.k}); }

template <class Row>
Diagnostics check_rows(const std::vector<Row>& rows) {
  double previous_nm = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string message = problem(rows[i]);
    if (message.empty()) message = wavelength_problem(rows[i].wavelength_nm, previous_nm);
    if (!message.empty()) return fail(Failure::content, "row " + std::to_string(i + 1) + ": " + message);
    previous_nm = rows[i].wavelength_nm;
  }
  return {};
}

// Linear in wavelength, the end values held: equation (38).
template <class Row, class Value>
auto interpolated(const std::vector<Row>& rows, double wavelength_nm, Value value) {
  const auto above = std::upper_bound(rows.begin(), rows.end(), wavelength_nm,
                                      [](double nm, const Row& row) { return nm < row.wavelength_nm; });
  if (above == rows.begin()) return value(rows.front());
  if (above == rows.end()) return value(rows.back());
  const Row &low = above[-1], &high = above[0];
  const double share = (wavelength_nm - low.wavelength_nm) / (high.wavelength_nm - low.wavelength_nm);
  return value(low) + share * (value(high) - value(low));
}

WavelengthRange common(WavelengthRange a, WavelengthRange b) {
  return {std::max(a.first_nm, b.first_nm), std::min(a.last_nm, b.last_nm)};
}

template <class Rows>
WavelengthRange extent(const Rows& rows) {
  return {rows.front().wavelength_nm, rows.back().wavelength_nm};
}

}  // namespace

Result<FormulaIndex> formula_index(DispersionFormula formula, WavelengthRange range,
                                   std::vector<AbsorptionSample> absorption) {
  if (!(range.first_nm > 0 && range.last_nm > range.first_nm && std::isfinite(range.last_nm)))
    return fail(Failure::content, "expected a range of two rising wavelengths > 0");
  const double ratio = range.last_nm / range.first_nm;
  for (int i = 0; i <= range_samples; ++i) {
    const double wavelength_nm =
        i == range_samples ? range.last_nm : range.first_nm * std::pow(ratio, double(i) / range_samples);
    const double n = formula.index(wavelength_nm);
    if (!is_index(n))
      return fail(Failure::content, "expected a formula that gives a real index of 0.0001..10000 over its range, got " +
                                        (std::isnan(n) ? "none" : format_number(n, 6)) + " at " +
                                        format_number(wavelength_nm, 6) + " nm");
  }
  if (const Diagnostics errors = check_rows(absorption); !errors.empty()) return errors;
  if (!absorption.empty()) {
    const WavelengthRange both = common(range, extent(absorption));
    if (both.first_nm > both.last_nm) return fail(Failure::content, no_common);
  }
  const WavelengthRange continued = {
      continued_to(formula, range.first_nm, std::min(range.first_nm, rendered_range_nm.first_nm)),
      continued_to(formula, range.last_nm, std::max(range.last_nm, rendered_range_nm.last_nm))};
  return FormulaIndex{std::move(formula), range, continued, std::move(absorption)};
}

Result<TableIndex> table_index(std::vector<IndexSample> rows, std::optional<WavelengthRange> range) {
  if (rows.empty()) return fail(Failure::content, "expected at least one row of wavelength, n and k");
  if (const Diagnostics errors = check_rows(rows); !errors.empty()) return errors;
  const WavelengthRange known = range ? common(*range, extent(rows)) : extent(rows);
  if (known.first_nm > known.last_nm) return fail(Failure::content, no_common);
  return TableIndex{std::move(rows), known};
}

Result<MixtureIndex> mixture_index(std::vector<MixturePart> parts) {
  if (parts.empty()) return fail(Failure::content, "expected at least one part of a mixture");
  double sum = 0;
  for (const MixturePart& part : parts) {
    if (!(part.fraction >= 0 && part.fraction <= 1))
      return fail(Failure::content, "expected fractions of the volume within 0..1");
    sum += part.fraction;
  }
  if (!(std::abs(sum - 1) <= most_sum_error))
    return fail(Failure::content,
                "expected fractions that make up the whole volume, got " + format_number(100 * sum, 6) + "%");
  return MixtureIndex{std::move(parts)};
}

std::complex<double> index_at(const ConstantIndex& constant, double) { return constant.index; }

std::complex<double> index_at(const FormulaIndex& formula, double wavelength_nm) {
  const double nm = std::clamp(wavelength_nm, formula.continued.first_nm, formula.continued.last_nm);
  double n = formula.formula.index(nm);
  // Between the wavelengths that were checked a pole may hide; nothing but a number leaves here.
  if (!is_index(n)) n = n > largest_index ? largest_index : smallest_index;
  if (formula.absorption.empty()) return n;
  return {n, interpolated(formula.absorption, wavelength_nm, [](const AbsorptionSample& row) { return row.k; })};
}

std::complex<double> index_at(const TableIndex& table, double wavelength_nm) {
  return interpolated(table.rows, wavelength_nm,
                      [](const IndexSample& row) { return std::complex<double>(row.n, row.k); });
}

std::complex<double> index_at(const MixtureIndex& mixture, double wavelength_nm) {
  std::vector<MixedIndex> parts;
  parts.reserve(mixture.parts.size());
  for (const MixturePart& part : mixture.parts) parts.push_back({part.medium.index(wavelength_nm), part.fraction});
  const std::complex<double> index = lorentz_lorenz_index(parts);
  // Polarisabilities that cancel to a pole have no index; metals in fine powder come near one.
  return std::isfinite(index.real()) && std::isfinite(index.imag()) ? index : largest_index;
}

bool lossless(const ConstantIndex& constant) { return constant.index.imag() == 0; }
bool lossless(const FormulaIndex& formula) {
  return std::all_of(formula.absorption.begin(), formula.absorption.end(), [](const auto& row) { return row.k == 0; });
}
bool lossless(const TableIndex& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const IndexSample& row) { return row.k == 0; });
}
bool lossless(const MixtureIndex& mixture) {
  return std::all_of(mixture.parts.begin(), mixture.parts.end(),
                     [](const MixturePart& part) { return part.medium.is_lossless(); });
}

ConstantIndex lossless_form(const ConstantIndex& constant) { return {constant.index.real()}; }
FormulaIndex lossless_form(const FormulaIndex& formula) {
  return {formula.formula, formula.range, formula.continued, {}};
}
TableIndex lossless_form(const TableIndex& table) {
  TableIndex result = table;
  for (IndexSample& row : result.rows) row.k = 0;
  return result;
}
MixtureIndex lossless_form(const MixtureIndex& mixture) {
  MixtureIndex result;
  for (const MixturePart& part : mixture.parts)
    result.parts.push_back({part.medium.without_absorption(), part.fraction});
  return result;
}

std::optional<WavelengthRange> range_of(const ConstantIndex&) { return {}; }
std::optional<WavelengthRange> range_of(const FormulaIndex& formula) {
  return formula.absorption.empty() ? formula.range : common(formula.range, extent(formula.absorption));
}
std::optional<WavelengthRange> range_of(const TableIndex& table) { return table.range; }
std::optional<WavelengthRange> range_of(const MixtureIndex& mixture) {
  std::optional<WavelengthRange> range;
  for (const MixturePart& part : mixture.parts)
    if (const auto own = part.medium.range_nm()) range = range ? common(*range, *own) : *own;
  return range;
}

}  // namespace shabon::optics
