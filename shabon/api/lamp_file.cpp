#include "shabon/api/lamp_file.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/api/nk_csv_dialect.h"
#include "shabon/base/text.h"
#include "shabon/io/csv.h"
#include "shabon/io/file.h"
#include "shabon/io/text_lines.h"

namespace shabon::api {

namespace {

// Shorter than any wavelength a lamp's table in nm ends at, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;

constexpr double nm_per_um = 1000;

struct Columns {
  std::size_t wavelength = 0, power = 1;
  double nm_per_unit = 1;
};

std::optional<Columns> find_columns(const io::CsvTable& table) {
  if (table.columns.empty()) return table.rows.front().cells.size() == 2 ? std::optional(Columns{}) : std::nullopt;
  std::optional<std::size_t> wavelength;
  double nm_per_unit = 1;
  for (const char* name : {"wavelength_nm", "lambda_nm", "wavelength_um", "lambda_um"}) {
    if (wavelength) break;
    wavelength = table.column(name);
    nm_per_unit = std::string_view(name).ends_with("_um") ? nm_per_um : 1;
  }
  if (!wavelength) return {};
  if (const std::optional<std::size_t> power = table.column("power")) return Columns{*wavelength, *power, nm_per_unit};
  return table.columns.size() == 2 ? std::optional(Columns{*wavelength, 1 - *wavelength, nm_per_unit}) : std::nullopt;
}

// At the first line that is no comment.
Diagnostics in_header(const io::CsvTable& table, const std::string& message) {
  for (std::size_t i = 0; i < table.lines.size(); ++i)
    if (const std::string_view line = trim(table.lines[i]); !line.empty() && line.front() != '#')
      return {io::diagnostic_at(table.source, table.lines, static_cast<int>(i) + 1, 1, message)};
  return fail(Failure::content, message);
}

Diagnostics in_file(const io::CsvTable& table, Diagnostics errors) {
  for (Diagnostic& error : errors) error.source = table.source;
  return errors;
}

Result<color::Illuminant> lamp_of(const Result<io::CsvTable>& table, const std::filesystem::path& path) {
  if (!table) return table.errors();
  const std::optional<Columns> columns = find_columns(*table);
  if (!columns) return in_header(*table, "expected the columns wavelength_nm (or wavelength_um) and power");
  Result<std::vector<double>> wavelengths_nm = io::numbers(*table, columns->wavelength);
  if (!wavelengths_nm) return wavelengths_nm.errors();
  for (double& nm : *wavelengths_nm) nm *= columns->nm_per_unit;
  const Result<std::vector<double>> powers = io::numbers(*table, columns->power);
  if (!powers) return powers.errors();

  double previous_nm = 0;
  for (std::size_t i = 0; i < powers->size(); ++i) {
    const double nm = (*wavelengths_nm)[i];
    const auto at = [&](std::size_t column, std::string message) {
      return Diagnostics{io::diagnostic_at(*table, table->rows[i], column, std::move(message))};
    };
    if (!(nm > 0)) return at(columns->wavelength, "expected a wavelength > 0 nm");
    if (!(nm > previous_nm)) return at(columns->wavelength, "expected rising wavelengths");
    if ((*powers)[i] < 0) return at(columns->power, "expected a power >= 0");
    previous_nm = nm;
  }
  if (previous_nm < shortest_plausible_last_nm)
    return in_file(*table,
                   fail(Failure::content, "expected wavelengths in nm; the last one is " + format_number(previous_nm) +
                                              ": are they micrometres? Then name the column wavelength_um"));
  std::string source;
  for (const std::string& comment : table->comments) source += (source.empty() ? "" : " ") + std::string(trim(comment));
  Result<color::Illuminant> lamp = color::illuminant_from_samples(
      "file:" + path.string(), source.empty() ? path.filename().string() : source, *wavelengths_nm, *powers);
  if (!lamp) return in_file(*table, lamp.errors());
  return lamp;
}

}  // namespace

Result<color::Illuminant> read_lamp_file(const std::filesystem::path& path) {
  const Result<std::string> text = io::read_text_file(path, io::csv_max_bytes);
  if (!text) return text.errors();
  const Result<std::string> plain = with_commas_and_points(*text, path.string());
  if (!plain) return plain.errors();
  Result<color::Illuminant> lamp = lamp_of(io::parse_csv(*plain, path.string()), path);
  if (lamp || *plain == *text) return lamp;
  // What was rewritten is shown as it stands in the file.
  Diagnostics errors = lamp.errors();
  const std::vector<std::string> lines = io::split_lines(io::with_plain_line_ends(*text));
  for (Diagnostic& error : errors)
    if (!error.excerpt.empty() && error.line >= 1 && static_cast<std::size_t>(error.line) <= lines.size())
      error.excerpt = lines[static_cast<std::size_t>(error.line) - 1];
  return errors;
}

}  // namespace shabon::api
