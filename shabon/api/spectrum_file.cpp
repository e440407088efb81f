#include "shabon/api/spectrum_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"

namespace shabon::api {

namespace {

using desk::Quantity;

constexpr double nm_per_um = 1000, largest_wavelength_nm = 1e9;
// Shorter than any wavelength a table in nm ends at, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;
// No table in micrometres begins so far in the infrared; one in nm does not begin before.
constexpr double longest_plausible_first_um = 100;
// Noise takes shares beyond 0..1, but not as far as this.
// More say no more about a film, and a search would take minutes.
constexpr std::size_t most_rows = 20'000;
constexpr double least_share = -0.5, most_share = 1.5;

struct Name {
  std::string_view text;
  Quantity quantity;
};
constexpr Name share_names[] = {
    {"r", Quantity::R},
    {"reflectance", Quantity::R},
    {"reflectivity", Quantity::R},
    {"reflection", Quantity::R},
    {"rs", Quantity::R_s},
    {"rp", Quantity::R_p},
    {"t", Quantity::T},
    {"transmittance", Quantity::T},
    {"transmissivity", Quantity::T},
    {"transmission", Quantity::T},
    {"ts", Quantity::T_s},
    {"tp", Quantity::T_p},
};
constexpr std::string_view nm_names[] = {"wavelengthnm", "lambdanm", "nm", "wavelength", "lambda"};
constexpr std::string_view um_names[] = {"wavelengthum", "lambdaum", "um", "wavelength\u00B5m", "wavelength\u03BCm"};
constexpr std::string_view angle_names[] = {"angledeg", "angle", "incidencedeg", "thetadeg", "aoi", "aoideg"};
constexpr const char* expected_columns = "expected the columns wavelength_nm and R, R_s, R_p, T, T_s or T_p";

struct Share {
  Quantity quantity;
  std::size_t column;
  bool percent;
};

struct Columns {
  std::optional<std::size_t> wavelength, angle;
  double nm_per_unit = 1;
  std::vector<Share> shares;

  bool has(Quantity quantity) const {
    return std::any_of(shares.begin(), shares.end(), [&](const Share& s) { return s.quantity == quantity; });
  }
};

// "R_s (%)" is "rs%".
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : lower(name))
    if (std::string_view(" \t_-()[]/").find(c) == std::string_view::npos) plain += c;
  return plain;
}

// Removes `%` or `percent`; whether there was one.
bool take_percent(std::string& name) {
  bool found = false;
  for (const std::string_view word : {std::string_view("percent"), std::string_view("%")})
    if (const std::size_t at = name.find(word); at != std::string::npos) name.erase(at, word.size()), found = true;
  return found;
}

bool holds(std::span<const std::string_view> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_comment_or_blank(std::string_view line) { return trim(line).empty() || trim(line).starts_with('#'); }

// At a name of the header, or at the first line.
Diagnostics in_header(const io::CsvTable& table, std::string message, std::string_view name = {}) {
  Diagnostics errors = fail(Failure::content, std::move(message));
  Diagnostic& error = errors.front();
  error.source = table.source;
  const auto line = std::find_if_not(table.lines.begin(), table.lines.end(), is_comment_or_blank);
  if (line == table.lines.end()) return errors;
  error.line = static_cast<int>(line - table.lines.begin()) + 1, error.excerpt = *line;
  const std::size_t at = name.empty() ? std::string::npos : line->rfind(name);
  const std::string_view before = std::string_view(*line).substr(0, at == std::string::npos ? 0 : at);
  error.column = static_cast<int>(utf8_characters(before).size()) + 1;
  return errors;
}

// `;` or tabs for separators, as tables are written where the comma is the decimal mark.
struct Separated {
  std::string text;  // with commas for separators and points; every character in its place
  bool changed = false;
};

Separated with_commas(std::string text) {
  std::istringstream lines(text);
  std::string first;
  while (std::getline(lines, first) && is_comment_or_blank(first)) continue;
  const bool has_comma = first.find(',') != std::string::npos;
  const char separator = first.find(';') != std::string::npos ? ';' : '\t';
  if (first.find(separator) == std::string::npos || (separator == '\t' && has_comma)) return {std::move(text)};
  bool is_comment = false, is_start = true;
  for (char& c : text) {
    if (is_start && c != ' ' && c != '\t') is_comment = c == '#', is_start = false;
    if (c == '\n') is_start = true, is_comment = false;
    if (is_comment) continue;
    if (c == ',')
      c = '.';
    else if (c == separator)
      c = ',';
  }
  return {std::move(text), true};
}

Result<io::CsvTable> read_table(const std::filesystem::path& path) {
  Result<std::string> text = io::read_file(path, io::csv_max_bytes);
  if (!text) return text.errors();
  const Separated separated = with_commas(*text);
  Result<io::CsvTable> table = io::parse_csv(separated.text, path.string());
  if (!separated.changed) return table;
  if (!table) {  // which would be shown in other words than the file's
    Diagnostics errors = table.errors();
    for (Diagnostic& error : errors) error.excerpt.clear();
    return errors;
  }
  return table;
}

// What a reader asked for, or everything except what is there twice.
void choose(Columns& columns, const std::vector<Quantity>& wanted) {
  const Columns all = columns;
  std::erase_if(columns.shares, [&](const Share& share) {
    if (!wanted.empty()) return std::find(wanted.begin(), wanted.end(), share.quantity) == wanted.end();
    return (share.quantity == Quantity::R && all.has(Quantity::R_s) && all.has(Quantity::R_p)) ||
           (share.quantity == Quantity::T && all.has(Quantity::T_s) && all.has(Quantity::T_p));
  });
}

Result<Columns> named_columns(const io::CsvTable& table, const SpectrumFileOptions& options) {
  Columns columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::string name = plain_name(table.columns[i]);
    const bool is_um = holds(um_names, name);
    if ((is_um || holds(nm_names, name)) && !columns.wavelength) {
      columns.wavelength = i;
      columns.nm_per_unit = is_um ? nm_per_um : 1;
    } else if (holds(angle_names, name) && !columns.angle) {
      columns.angle = i;
    } else {
      const bool percent = take_percent(name);
      for (const Name& known : share_names) {
        if (known.text != name) continue;
        if (columns.has(known.quantity))
          return in_header(
              table,
              "expected one column for each share, got '" + printable(table.columns[i], 60) + "' as a second one",
              table.columns[i]);
        columns.shares.push_back({known.quantity, i, percent || options.percent});
      }
    }
  }
  choose(columns, options.columns);
  if (!columns.wavelength || columns.shares.empty()) {
    std::string found;
    for (const std::string& name : table.columns) found += (found.empty() ? "" : ", ") + printable(name, 60);
    return in_header(table, std::string(expected_columns) + ", got " + found);
  }
  for (const Quantity wanted : options.columns)
    if (!columns.has(wanted))
      return in_header(
          table,
          "expected a column " + std::string(desk::quantities()[static_cast<std::size_t>(wanted)].name) + ", got none");
  return columns;
}

Result<Columns> columns_of(const io::CsvTable& table, const SpectrumFileOptions& options) {
  if (!table.columns.empty()) return named_columns(table, options);
  if (table.rows.front().cells.size() != 2)
    return in_header(table, std::string(expected_columns) + ", or two columns without names");
  const Quantity quantity = options.columns.empty() ? Quantity::R : options.columns.front();
  return Columns{0, {}, 1, {{quantity, 1, options.percent}}};
}

// One column, each value scaled and checked.
template <class Check>
Result<std::vector<double>> column_of(const io::CsvTable& table, std::size_t column, double factor,
                                      const Check& wrong) {
  Result<std::vector<double>> values = io::numbers(table, column);
  if (!values) return values;
  for (std::size_t i = 0; i < values->size(); ++i) {
    (*values)[i] *= factor;
    const std::string message = wrong((*values)[i]);
    if (!message.empty()) return Diagnostics{io::diagnostic_at(table, table.rows[i], column, message)};
  }
  return values;
}

std::string wrong_wavelength(double nm) {
  return nm > 0 && nm <= largest_wavelength_nm ? "" : "expected a wavelength > 0 nm and of at most 1 m";
}

std::string wrong_angle(double deg) {
  return deg >= 0 && deg <= 90 ? "" : "expected an angle of 0..90 degrees, got " + format_number(deg);
}

// Wavelengths that only another unit would explain.
Status check_unit(const io::CsvTable& table, const Columns& columns, const std::vector<double>& wavelengths_nm) {
  const auto refuse = [&](std::size_t row, const char* unit, const std::string& told, const char* other) {
    return Diagnostics{
        io::diagnostic_at(table, table.rows[row], *columns.wavelength,
                          std::string("expected wavelengths in ") + unit + "; " + told + ": are they " + other)};
  };
  const auto [least, most] = std::minmax_element(wavelengths_nm.begin(), wavelengths_nm.end());
  const auto row_of = [&](auto at) { return static_cast<std::size_t>(at - wavelengths_nm.begin()); };
  if (columns.nm_per_unit == 1 && *most < shortest_plausible_last_nm)
    return refuse(row_of(most), "nm", "the longest is " + format_number(*most, 6),
                  "micrometres? Then name the column wavelength_um");
  if (columns.nm_per_unit == nm_per_um && *least > longest_plausible_first_um * nm_per_um)
    return refuse(row_of(least), "micrometres", "the shortest is " + format_number(*least / nm_per_um, 6),
                  "nm? Then name the column wavelength_nm");
  return Done{};
}

// What the last digit of a column stands for: of the cell with the most digits behind the point.
double last_digit(const io::CsvTable& table, std::size_t column) {
  constexpr int most_digits = 17;  // of a double
  int most = -most_digits;
  for (const io::CsvRow& row : table.rows) {
    const std::string text = lower(row.cells[column].text);
    const std::size_t end = std::min(text.find('e'), text.size()), point = text.find('.');
    int digits = point < end ? static_cast<int>(end - point) - 1 : 0;
    if (end < text.size()) digits -= static_cast<int>(parse_number(text.substr(end + 1)).value_or(0));
    most = std::max(most, std::min(digits, most_digits));
  }
  return std::pow(10.0, -most);
}

}  // namespace

Result<desk::MeasuredSpectrum> read_spectrum_file(const std::filesystem::path& path,
                                                  const SpectrumFileOptions& options) {
  const Result<io::CsvTable> table = read_table(path);
  if (!table) return table.errors();
  if (table->rows.size() > most_rows)
    return Diagnostics{io::diagnostic_at(*table, table->rows[most_rows], 0,
                                         "expected at most " + std::to_string(most_rows) + " rows, got " +
                                             std::to_string(table->rows.size()) +
                                             ": means of neighbouring rows say as much about a film")};
  const Result<Columns> columns = columns_of(*table, options);
  if (!columns) return columns.errors();

  const auto wavelengths_nm = column_of(*table, *columns->wavelength, columns->nm_per_unit, wrong_wavelength);
  if (!wavelengths_nm) return wavelengths_nm.errors();
  if (const Status status = check_unit(*table, *columns, *wavelengths_nm); !status) return status.errors();
  desk::MeasuredSpectrum spectrum;
  for (const double nm : *wavelengths_nm) spectrum.rows.push_back({nm, options.incidence_deg, {}});
  spectrum.has_angles = columns->angle.has_value();
  if (columns->angle) {
    const auto angles_deg = column_of(*table, *columns->angle, 1, wrong_angle);
    if (!angles_deg) return angles_deg.errors();
    for (std::size_t i = 0; i < angles_deg->size(); ++i) spectrum.rows[i].incidence_deg = (*angles_deg)[i];
  }
  double finest = 1;  // shares without a digit behind the point tell nothing
  for (const Share& share : columns->shares) {
    const auto wrong = [&](double value) -> std::string {
      if (value >= least_share && value <= most_share) return "";
      const std::string got = share.percent ? format_number(value * 100, 6) + " %" : format_number(value, 6);
      return "expected a share of the incident light, 0..1, got " + got +
             (share.percent ? "" : ": is it in percent? (--percent, or a column name such as R_percent)");
    };
    const double factor = share.percent ? 0.01 : 1;
    const auto values = column_of(*table, share.column, factor, wrong);
    if (!values) return values.errors();
    finest = std::min(finest, factor * last_digit(*table, share.column));
    spectrum.quantities.push_back(share.quantity);
    for (std::size_t i = 0; i < values->size(); ++i) spectrum.rows[i].shares.push_back((*values)[i]);
  }
  spectrum.step = finest < 1 ? finest : 0;
  return spectrum;
}

}  // namespace shabon::api
