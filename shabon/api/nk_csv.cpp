#include "shabon/api/nk_csv.h"

#include "shabon/base/text.h"
#include "shabon/io/csv.h"

namespace shabon::api {

namespace {

// Shorter than any wavelength an optical table in nm holds, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;

Diagnostics at_header(const io::CsvTable& table, std::string message) {
  Diagnostics errors = fail(Failure::content, std::move(message));
  errors.front().source = table.source;
  return errors;
}

struct Columns {
  std::size_t wavelength = 0, n = 1;
  std::optional<std::size_t> k;
};

Result<Columns> find_columns(const io::CsvTable& table) {
  if (table.columns.empty()) {
    const std::size_t count = table.rows.front().cells.size();
    if (count != 2 && count != 3) return at_header(table, "expected 2 or 3 columns: wavelength in nm, n and perhaps k");
    return Columns{0, 1, count == 3 ? std::optional<std::size_t>(2) : std::nullopt};
  }
  std::optional<std::size_t> wavelength = table.column("wavelength_nm");
  if (!wavelength) wavelength = table.column("lambda_nm");
  const std::optional<std::size_t> n = table.column("n");
  if (!wavelength || !n) return at_header(table, "expected the columns wavelength_nm, n and perhaps k");
  return Columns{*wavelength, *n, table.column("k")};
}

// Bad rows are told at their line; the table as a whole is checked by the medium.
std::optional<std::string> problem(const optics::IndexSample& row, double previous_nm) {
  if (!(row.wavelength_nm > 0)) return "expected a wavelength > 0 nm";
  if (!(row.wavelength_nm > previous_nm)) return "expected rising wavelengths";
  if (row.n < 0 || row.k < 0) return "expected n and k >= 0";
  if (row.n == 0 && row.k == 0) return "n and k are both 0";
  return {};
}

}  // namespace

Result<optics::Medium> read_nk_csv(const std::filesystem::path& path) {
  const Result<io::CsvTable> table = io::read_csv(path);
  if (!table) return table.errors();
  Result<Columns> columns = find_columns(*table);
  if (!columns) return columns.errors();
  const Result<std::vector<double>> wavelength_nm = io::numbers(*table, columns->wavelength);
  if (!wavelength_nm) return wavelength_nm.errors();
  const Result<std::vector<double>> n = io::numbers(*table, columns->n);
  if (!n) return n.errors();
  Result<std::vector<double>> k = columns->k ? io::numbers(*table, *columns->k) : std::vector<double>(n->size(), 0.0);
  if (!k) return k.errors();

  std::vector<optics::IndexSample> rows;
  double previous_nm = 0;
  for (std::size_t i = 0; i < n->size(); ++i) {
    const optics::IndexSample row{(*wavelength_nm)[i], (*n)[i], (*k)[i]};
    if (const auto message = problem(row, previous_nm))
      return Diagnostics{io::diagnostic_at(*table, table->rows[i], columns->wavelength, *message)};
    previous_nm = row.wavelength_nm;
    rows.push_back(row);
  }
  if (previous_nm < shortest_plausible_last_nm)
    return at_header(*table, "expected wavelengths in nm; the last one is " + format_number(previous_nm) +
                                 ": are they micrometres?");
  std::string source;
  for (const std::string& comment : table->comments) source += (source.empty() ? "" : " ") + std::string(trim(comment));
  return optics::Medium::table(std::move(rows), {path.filename().string(), "n and k from a file", source});
}

}  // namespace shabon::api
