#include "shabon/api/nk_csv.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/text_lines.h"

namespace shabon::api {

namespace {

constexpr double nm_per_um = 1000;
// Shorter than any wavelength an optical table in nm holds, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;

// What a column may be called. Names ignore case, blanks, '_', '-' and brackets: "Wavelength (nm)" is "wavelengthnm".
constexpr std::string_view nm_names[] = {"wavelengthnm", "lambdanm", "wavenm", "wlnm", "nm", "wavelength", "lambda"};
// `wl` alone is what refractiveindex.info writes, in micrometres.
constexpr std::string_view um_names[] = {
    "wavelengthum",     "lambdaum",          "waveum",           "wlum", "um", "wl",
    "wavelengthmicron", "wavelength\u00B5m", "wavelength\u03BCm"};
constexpr std::string_view n_names[] = {"n", "index", "refractiveindex"};
constexpr std::string_view k_names[] = {"k", "kappa", "extinction", "extinctioncoefficient"};
constexpr const char* expected_columns = "expected the columns wavelength_nm (or wavelength_um), n and perhaps k";

std::string plain_name(std::string_view name) {
  std::string result;
  for (const char c : lower(name))
    if (std::string_view(" \t_-()[]/").find(c) == std::string_view::npos) result += c;
  return result;
}

bool holds(std::span<const std::string_view> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// An error at a name of the header; the header is the first line that is neither empty nor a comment.
Diagnostic at_name(const io::CsvTable& table, std::size_t column, std::string message) {
  const auto is_header = [](const std::string& line) { return !trim(line).empty() && line.front() != '#'; };
  const auto header = std::find_if(table.lines.begin(), table.lines.end(), is_header);
  if (header == table.lines.end()) return io::diagnostic_at(table.source, table.lines, 1, 1, std::move(message));
  std::size_t begin = 0;
  for (std::size_t i = 0; i < column; ++i) begin = std::min(header->find(',', begin), header->size() - 1) + 1;
  begin = std::min(header->find_first_not_of(" \t", begin), header->size());
  const int line = static_cast<int>(header - table.lines.begin()) + 1;
  return io::diagnostic_at(table.source, table.lines, line, static_cast<int>(io::count_characters(*header, begin)) + 1,
                           std::move(message));
}

struct Columns {
  std::optional<std::size_t> wavelength, n, k;
  double nm_per_unit = 1;
};

Result<Columns> columns_by_place(const io::CsvTable& table) {
  const std::size_t count = table.rows.front().cells.size();
  if (count != 2 && count != 3)
    return Diagnostics{
        io::diagnostic_at(table, table.rows.front(), std::min<std::size_t>(count, 4) - 1,
                          "expected 2 or 3 columns (wavelength in nm, n and perhaps k), got " + std::to_string(count))};
  return Columns{0, 1, count == 3 ? std::optional<std::size_t>(2) : std::nullopt};
}

Result<Columns> columns_by_name(const io::CsvTable& table) {
  Columns columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string name = plain_name(table.columns[i]);
    const bool um = holds(um_names, name);
    std::optional<std::size_t>* which = um || holds(nm_names, name) ? &columns.wavelength
                                        : holds(n_names, name)      ? &columns.n
                                        : holds(k_names, name)      ? &columns.k
                                                                    : nullptr;
    if (which == nullptr || *which)
      return Diagnostics{at_name(table, i,
                                 std::string(expected_columns) + ", got '" + printable(table.columns[i], 60) +
                                     (which ? "' as a second one" : "'"))};
    *which = i;
    if (um) columns.nm_per_unit = nm_per_um;
  }
  if (columns.wavelength && columns.n) return columns;
  return Diagnostics{at_name(
      table, 0, std::string(expected_columns) + ", got no column of " + (columns.wavelength ? "n" : "wavelengths"))};
}

// Bad rows are told at their line; the table as a whole is checked by the medium.
struct RowProblem {
  std::size_t column;
  std::string message;
};
std::optional<RowProblem> problem(const optics::IndexSample& row, double previous_nm, const Columns& columns) {
  if (!(row.wavelength_nm > 0))
    return RowProblem{*columns.wavelength, "expected a wavelength > 0, got " + format_number(row.wavelength_nm)};
  if (!(row.wavelength_nm > previous_nm))
    return RowProblem{*columns.wavelength, "expected rising wavelengths, got " + format_number(row.wavelength_nm) +
                                               " nm after " + format_number(previous_nm) + " nm"};
  if (row.n < 0) return RowProblem{*columns.n, "expected n >= 0, got " + format_number(row.n)};
  if (row.k < 0) return RowProblem{*columns.k, "expected k >= 0 (n + ik absorbs), got " + format_number(row.k)};
  if (row.n == 0 && row.k == 0) return RowProblem{*columns.n, "expected an index other than 0"};
  return {};
}

}  // namespace

Result<optics::Medium> read_nk_csv(const std::filesystem::path& path) {
  const Result<io::CsvTable> table = io::read_csv(path);
  if (!table) return table.errors();
  const Result<Columns> columns = table->columns.empty() ? columns_by_place(*table) : columns_by_name(*table);
  if (!columns) return columns.errors();
  const Result<std::vector<double>> wavelengths = io::numbers(*table, *columns->wavelength);
  if (!wavelengths) return wavelengths.errors();
  const Result<std::vector<double>> n = io::numbers(*table, *columns->n);
  if (!n) return n.errors();
  const Result<std::vector<double>> k =
      columns->k ? io::numbers(*table, *columns->k) : std::vector<double>(n->size(), 0.0);
  if (!k) return k.errors();

  std::vector<optics::IndexSample> rows;
  double previous_nm = 0;
  for (std::size_t i = 0; i < n->size(); ++i) {
    const optics::IndexSample row{(*wavelengths)[i] * columns->nm_per_unit, (*n)[i], (*k)[i]};
    if (const auto found = problem(row, previous_nm, *columns))
      return Diagnostics{io::diagnostic_at(*table, table->rows[i], found->column, found->message)};
    previous_nm = row.wavelength_nm;
    rows.push_back(row);
  }
  if (previous_nm < shortest_plausible_last_nm)
    return Diagnostics{io::diagnostic_at(*table, table->rows.back(), *columns->wavelength,
                                         "expected wavelengths in nm, got " + format_number(previous_nm) +
                                             " nm as the longest; a column of micrometres is named wavelength_um")};
  std::string source;
  for (const std::string& comment : table->comments) source += (source.empty() ? "" : " ") + std::string(trim(comment));
  return optics::Medium::table(std::move(rows), {path.filename().string(), "n and k from a file", source});
}

}  // namespace shabon::api
