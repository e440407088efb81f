#include "shabon/optics/medium.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

struct ConstantIndex {
  std::complex<double> index;
  friend bool operator==(const ConstantIndex&, const ConstantIndex&) = default;
};

struct FormulaIndex {
  DispersionFormula formula;
  WavelengthRange range;
  friend bool operator==(const FormulaIndex&, const FormulaIndex&) = default;
};

struct TableIndex {
  std::vector<IndexSample> rows;
  friend bool operator==(const TableIndex&, const TableIndex&) = default;
};

std::complex<double> index_at(const ConstantIndex& constant, double) { return constant.index; }

std::complex<double> index_at(const FormulaIndex& formula, double wavelength_nm) {
  const double first_nm = std::min(formula.range.first_nm, rendered_range_nm.first_nm);
  const double last_nm = std::max(formula.range.last_nm, rendered_range_nm.last_nm);
  return formula.formula.index(std::clamp(wavelength_nm, first_nm, last_nm));
}

std::complex<double> index_at(const TableIndex& table, double wavelength_nm) {
  const std::vector<IndexSample>& rows = table.rows;
  const auto above = std::upper_bound(rows.begin(), rows.end(), wavelength_nm,
                                      [](double nm, const IndexSample& row) { return nm < row.wavelength_nm; });
  if (above == rows.begin()) return {rows.front().n, rows.front().k};
  if (above == rows.end()) return {rows.back().n, rows.back().k};
  const IndexSample &low = above[-1], &high = above[0];
  const double share = (wavelength_nm - low.wavelength_nm) / (high.wavelength_nm - low.wavelength_nm);
  return {std::lerp(low.n, high.n, share), std::lerp(low.k, high.k, share)};
}

std::optional<WavelengthRange> range_of(const ConstantIndex&) { return {}; }
std::optional<WavelengthRange> range_of(const FormulaIndex& formula) { return formula.range; }
std::optional<WavelengthRange> range_of(const TableIndex& table) {
  return WavelengthRange{table.rows.front().wavelength_nm, table.rows.back().wavelength_nm};
}

bool lossless(const ConstantIndex& constant) { return constant.index.imag() == 0; }
bool lossless(const FormulaIndex&) { return true; }
bool lossless(const TableIndex& table) {
  return std::all_of(table.rows.begin(), table.rows.end(), [](const IndexSample& row) { return row.k == 0; });
}

// What is wrong with a row that follows the wavelength `previous_nm`; empty when nothing is.
std::string row_problem(const IndexSample& row, double previous_nm) {
  if (!std::isfinite(row.wavelength_nm) || !std::isfinite(row.n) || !std::isfinite(row.k))
    return "expected finite numbers";
  if (row.wavelength_nm <= 0) return "expected a wavelength > 0 nm, got " + format_number(row.wavelength_nm);
  if (row.wavelength_nm <= previous_nm)
    return "expected rising wavelengths, got " + format_number(row.wavelength_nm) + " nm after " +
           format_number(previous_nm) + " nm";
  if (row.n < 0) return "expected n >= 0, got " + format_number(row.n);
  if (row.k < 0) return "expected k >= 0 (n + ik absorbs), got " + format_number(row.k);
  if (row.n == 0 && row.k == 0) return "expected an index other than 0";
  return {};
}

}  // namespace

struct Medium::Content {
  MediumDescription description;
  std::variant<ConstantIndex, FormulaIndex, TableIndex> index;
};

Medium::Medium(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Medium::Medium() {
  static const Medium vacuum = constant(1, {"vacuum", "vacuum", "exactly 1 by definition"});
  content_ = vacuum.content_;
}

Medium Medium::constant(std::complex<double> index) {
  std::string name = format_number(index.real());
  if (index.imag() != 0) name = (index.real() == 0 ? "" : name + "+") + format_number(index.imag()) + "i";
  return constant(index, {std::move(name), "constant index", "given by the user"});
}

Medium Medium::constant(std::complex<double> index, MediumDescription description) {
  return Medium(std::make_shared<const Content>(Content{std::move(description), ConstantIndex{index}}));
}

Medium Medium::formula(DispersionFormula formula, WavelengthRange range, MediumDescription description) {
  return Medium(
      std::make_shared<const Content>(Content{std::move(description), FormulaIndex{std::move(formula), range}}));
}

Result<Medium> Medium::table(std::vector<IndexSample> rows, MediumDescription description) {
  if (rows.empty()) return fail(Failure::content, "expected at least one row of wavelength, n and k");
  double previous_nm = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string problem = row_problem(rows[i], previous_nm);
    if (!problem.empty()) return fail(Failure::content, "row " + std::to_string(i + 1) + ": " + problem);
    previous_nm = rows[i].wavelength_nm;
  }
  return Medium(std::make_shared<const Content>(Content{std::move(description), TableIndex{std::move(rows)}}));
}

std::complex<double> Medium::index(double wavelength_nm) const {
  return std::visit([&](const auto& index) { return index_at(index, wavelength_nm); }, content_->index);
}

bool Medium::is_constant() const { return std::holds_alternative<ConstantIndex>(content_->index); }

bool Medium::is_lossless() const {
  return std::visit([](const auto& index) { return lossless(index); }, content_->index);
}

const std::string& Medium::name() const { return content_->description.name; }
const std::string& Medium::description() const { return content_->description.description; }
const std::string& Medium::source() const { return content_->description.source; }

std::optional<WavelengthRange> Medium::range_nm() const {
  return std::visit([](const auto& index) { return range_of(index); }, content_->index);
}

bool Medium::covers(double wavelength_nm) const {
  const auto range = range_nm();
  return !range || (wavelength_nm >= range->first_nm && wavelength_nm <= range->last_nm);
}

std::string Medium::outside_range_note() const {
  const auto range = range_nm();
  if (!range) return {};
  const bool table = std::holds_alternative<TableIndex>(content_->index);
  return name() + ": wavelengths outside " + format_number(range->first_nm) + ".." + format_number(range->last_nm) +
         " nm: " + (table ? "the table's end values are held" : "the formula is continued");
}

bool operator==(const Medium& a, const Medium& b) {
  return a.content_ == b.content_ || a.content_->index == b.content_->index;
}

}  // namespace shabon::optics
