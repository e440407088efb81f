#include "shabon/api/lamp_file.h"

#include <optional>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"

namespace shabon::api {

namespace {

// Shorter than any wavelength a lamp's table in nm ends at, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;

struct Columns {
  std::size_t wavelength = 0, power = 1;
};

std::optional<Columns> find_columns(const io::CsvTable& table) {
  if (table.columns.empty()) return table.rows.front().cells.size() == 2 ? std::optional(Columns{}) : std::nullopt;
  std::optional<std::size_t> wavelength = table.column("wavelength_nm");
  if (!wavelength) wavelength = table.column("lambda_nm");
  if (!wavelength) return {};
  if (const std::optional<std::size_t> power = table.column("power")) return Columns{*wavelength, *power};
  return table.columns.size() == 2 ? std::optional(Columns{*wavelength, 1 - *wavelength}) : std::nullopt;
}

Diagnostics in_file(const io::CsvTable& table, Diagnostics errors) {
  for (Diagnostic& error : errors) error.source = table.source;
  return errors;
}

}  // namespace

Result<color::Illuminant> read_lamp_file(const std::filesystem::path& path) {
  const Result<io::CsvTable> table = io::read_csv(path);
  if (!table) return table.errors();
  const std::optional<Columns> columns = find_columns(*table);
  if (!columns) return in_file(*table, fail(Failure::content, "expected the columns wavelength_nm and power"));
  const Result<std::vector<double>> wavelengths_nm = io::numbers(*table, columns->wavelength);
  if (!wavelengths_nm) return wavelengths_nm.errors();
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
    return in_file(*table, fail(Failure::content, "expected wavelengths in nm; the last one is " +
                                                      format_number(previous_nm) + ": are they micrometres?"));
  std::string source;
  for (const std::string& comment : table->comments) source += (source.empty() ? "" : " ") + std::string(trim(comment));
  Result<color::Illuminant> lamp = color::illuminant_from_samples(
      "file:" + path.string(), source.empty() ? path.filename().string() : source, *wavelengths_nm, *powers);
  if (!lamp) return in_file(*table, lamp.errors());
  return lamp;
}

}  // namespace shabon::api
