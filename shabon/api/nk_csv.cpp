#include "shabon/api/nk_csv.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/api/nk_csv_dialect.h"
#include "shabon/api/nk_join.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"
#include "shabon/io/text_lines.h"

namespace shabon::api {

namespace {

constexpr double nm_per_um = 1000;
// Shorter than any wavelength an optical table in nm holds, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;
// A table in micrometres that begins here knows nothing of light; one in nm does.
constexpr double longest_plausible_first_nm = 100 * nm_per_um;

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

// The names that a table began with, each with its place: the header is the first line that is neither empty nor a
// comment.
io::CsvRow header_of(const io::CsvTable& table) {
  const auto is_header = [](const std::string& line) { return !trim(line).empty() && line.front() != '#'; };
  const auto line = std::find_if(table.lines.begin(), table.lines.end(), is_header);
  io::CsvRow header{static_cast<int>(line - table.lines.begin()) + 1, {}};
  std::size_t begin = 0;
  for (const std::string& name : table.columns) {
    const std::size_t shown = std::min(line->find_first_not_of(" \t", begin), line->size());
    header.cells.push_back({name, static_cast<int>(io::count_characters(*line, shown)) + 1});
    begin = std::min(line->find(',', begin), line->size() - 1) + 1;
  }
  return header;
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
  // "400,1,52": is that n = 1.52, or n = 1 and k = 52?
  const bool whole = count == 3 && std::all_of(table.rows.begin(), table.rows.end(), [](const io::CsvRow& row) {
                       return std::all_of(row.cells.begin(), row.cells.end(),
                                          [](const io::CsvCell& cell) { return parse_integer(cell.text).has_value(); });
                     });
  const auto absorbs = [](const io::CsvRow& row) { return parse_number(row.cells[2].text) != 0.0; };
  if (whole && std::any_of(table.rows.begin(), table.rows.end(), absorbs))
    return Diagnostics{
        io::diagnostic_at(table, table.rows.front(), 1,
                          "expected decimal points, or ';' between the columns where ',' is the decimal "
                          "point, got whole numbers only; a header of wavelength_nm,n,k makes it clear")};
  return Columns{0, 1, count == 3 ? std::optional<std::size_t>(2) : std::nullopt};
}

Result<Columns> columns_by_name(const io::CsvTable& table, const io::CsvRow& header) {
  Columns columns;
  const auto refuse = [&](std::size_t column, const std::string& what) {
    return Diagnostics{io::diagnostic_at(table, header, column, std::string(expected_columns) + ", got " + what)};
  };
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string name = plain_name(header.cells[i].text);
    const bool um = holds(um_names, name);
    std::optional<std::size_t>* which = um || holds(nm_names, name) ? &columns.wavelength
                                        : holds(n_names, name)      ? &columns.n
                                        : holds(k_names, name)      ? &columns.k
                                                                    : nullptr;
    if (which == nullptr || *which)
      return refuse(i, "'" + printable(header.cells[i].text, 60) + (which ? "' as a second one" : "'"));
    *which = i;
    if (um) columns.nm_per_unit = nm_per_um;
  }
  if (!columns.wavelength) return refuse(0, "no column of wavelengths");
  if (!columns.n && !columns.k) return refuse(0, "no column of n");
  return columns;
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
  if (columns.n && row.n < 0) return RowProblem{*columns.n, "expected n >= 0, got " + format_number(row.n)};
  if (columns.k && row.k < 0)
    return RowProblem{*columns.k, "expected k >= 0 (n + ik absorbs), got " + format_number(row.k)};
  if (columns.n && row.n == 0 && row.k == 0) return RowProblem{*columns.n, "expected an index other than 0"};
  return {};
}

// One header and its rows.
struct Block {
  Columns columns;
  std::vector<optics::IndexSample> rows;  // n or k is 0 where there is no such column
};

// Wavelengths in another unit than their column says are found by their size.
std::optional<Diagnostic> unit_problem(const io::CsvTable& table, const Block& block) {
  const auto at = [&](const io::CsvRow& row, std::string message) {
    return io::diagnostic_at(table, row, *block.columns.wavelength, std::move(message));
  };
  const double first_nm = block.rows.front().wavelength_nm, last_nm = block.rows.back().wavelength_nm;
  if (last_nm < shortest_plausible_last_nm)
    return at(table.rows.back(), "expected wavelengths in nm, got " + format_number(last_nm) +
                                     " nm as the longest; a column of micrometres is named wavelength_um");
  if (block.columns.nm_per_unit == nm_per_um && first_nm >= longest_plausible_first_nm)
    return at(table.rows.front(), "expected wavelengths in micrometres, got " + format_number(first_nm / nm_per_um) +
                                      " as the shortest; a column of nanometres is named wavelength_nm");
  return {};
}

Result<Block> read_block(const io::CsvTable& table, const Columns& columns) {
  const std::vector<double> none(table.rows.size(), 0.0);
  const auto column = [&](std::optional<std::size_t> index) -> Result<std::vector<double>> {
    return index ? io::numbers(table, *index) : none;
  };
  const Result<std::vector<double>> wavelengths = column(columns.wavelength), n = column(columns.n),
                                    k = column(columns.k);
  for (const auto* numbers : {&wavelengths, &n, &k})
    if (!*numbers) return numbers->errors();
  Block block{columns, {}};
  double previous_nm = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const optics::IndexSample row{(*wavelengths)[i] * columns.nm_per_unit, (*n)[i], (*k)[i]};
    if (const auto found = problem(row, previous_nm, columns))
      return Diagnostics{io::diagnostic_at(table, table.rows[i], found->column, found->message)};
    previous_nm = row.wavelength_nm;
    block.rows.push_back(row);
  }
  if (auto found = unit_problem(table, block)) return Diagnostics{*std::move(found)};
  return block;
}

// A row of names below rows of numbers: the second table of a file, as refractiveindex.info exports n and k.
std::vector<io::CsvRow>::const_iterator second_header(const io::CsvTable& table) {
  return std::find_if(table.rows.begin(), table.rows.end(), [](const io::CsvRow& row) {
    return std::all_of(row.cells.begin(), row.cells.end(), [](const io::CsvCell& cell) {
      const std::string name = plain_name(cell.text);
      return holds(nm_names, name) || holds(um_names, name) || holds(n_names, name) || holds(k_names, name);
    });
  });
}

Result<std::vector<Block>> read_blocks(const io::CsvTable& table) {
  const Result<Columns> columns =
      table.columns.empty() ? columns_by_place(table) : columns_by_name(table, header_of(table));
  if (!columns) return columns.errors();
  const auto second = second_header(table);
  if (!columns->n && second == table.rows.end())
    return Diagnostics{
        io::diagnostic_at(table, header_of(table), 0, std::string(expected_columns) + ", got no column of n")};
  io::CsvTable part = table;
  part.rows.assign(table.rows.begin(), second);
  if (part.rows.empty())
    return Diagnostics{io::diagnostic_at(table, *second, 0, "expected rows of numbers below the names, got names")};
  std::vector<Block> blocks;
  const Result<Block> first = read_block(part, *columns);
  if (!first) return first.errors();
  blocks.push_back(*first);
  if (second == table.rows.end()) return blocks;

  const Result<Columns> further = columns_by_name(table, *second);
  if (!further) return further.errors();
  const bool apart = columns->n.has_value() != columns->k.has_value() &&
                     further->n.has_value() == columns->k.has_value() &&
                     further->k.has_value() == columns->n.has_value();
  part.rows.assign(second + 1, table.rows.end());
  if (!apart || part.rows.empty())
    return Diagnostics{
        io::diagnostic_at(table, *second, 0, "expected one table, or one of n and one of k below it, got names again")};
  const Result<Block> last = read_block(part, *further);
  if (!last) return last.errors();
  blocks.push_back(*last);
  return blocks;
}

Result<optics::Medium> medium_of(const io::CsvTable& table, const std::filesystem::path& path) {
  Result<std::vector<Block>> blocks = read_blocks(table);
  if (!blocks) return blocks.errors();
  std::string source;
  for (const std::string& comment : table.comments) source += (source.empty() ? "" : " ") + std::string(trim(comment));
  optics::MediumDescription description{path.filename().string(), "n and k from a file", source};
  if (blocks->size() == 1) return optics::Medium::table(std::move(blocks->front().rows), std::move(description));
  std::vector<NkSample> n, k;
  for (const Block& block : *blocks)
    for (const optics::IndexSample& row : block.rows)
      (block.columns.n ? n : k).push_back({row.wavelength_nm, block.columns.n ? row.n : row.k});
  return joined_table(n, k, std::move(description));
}

}  // namespace

Result<optics::Medium> read_nk_csv(const std::filesystem::path& path) {
  const Result<std::string> text = io::read_text_file(path, io::csv_max_bytes);
  if (!text) return text.errors();
  const Result<std::string> plain = with_commas_and_points(*text, path.string());
  if (!plain) return plain.errors();
  const Result<io::CsvTable> table = io::parse_csv(*plain, path.string());
  Result<optics::Medium> medium = table ? medium_of(*table, path) : Result<optics::Medium>(table.errors());
  if (medium) return medium;
  // What was rewritten is shown as it stands in the file.
  Diagnostics errors = medium.errors();
  const std::vector<std::string> lines =
      *plain == *text ? std::vector<std::string>() : io::split_lines(io::with_plain_line_ends(*text));
  for (Diagnostic& error : errors)
    if (!error.excerpt.empty() && error.line >= 1 && static_cast<std::size_t>(error.line) <= lines.size())
      error.excerpt = lines[static_cast<std::size_t>(error.line) - 1];
  return errors;
}

}  // namespace shabon::api
