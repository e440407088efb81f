#include "shabon/api/spectrum_file.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "shabon/base/text.h"
#include "shabon/io/csv.h"

namespace shabon::api {

namespace {

using desk::Quantity;

constexpr double nm_per_um = 1000, largest_wavelength_nm = 1e9;
// Shorter than any wavelength a table in nm ends at, longer than any that one in micrometres would.
constexpr double shortest_plausible_last_nm = 30;
// Noise takes shares beyond 0..1, but not as far as this.
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

Diagnostics in_file(const io::CsvTable& table, std::string message) {
  Diagnostics errors = fail(Failure::content, std::move(message));
  errors.front().source = table.source;
  return errors;
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
          return in_file(table, "expected one column for each share, got '" + printable(table.columns[i], 60) +
                                    "' as a second one");
        columns.shares.push_back({known.quantity, i, percent || options.percent});
      }
    }
  }
  choose(columns, options.columns);
  if (!columns.wavelength || columns.shares.empty()) {
    std::string found;
    for (const std::string& name : table.columns) found += (found.empty() ? "" : ", ") + printable(name, 60);
    return in_file(table, std::string(expected_columns) + ", got " + found);
  }
  for (const Quantity wanted : options.columns)
    if (!columns.has(wanted))
      return in_file(table, "expected a column " +
                                std::string(desk::quantities()[static_cast<std::size_t>(wanted)].name) + ", got none");
  return columns;
}

Result<Columns> columns_of(const io::CsvTable& table, const SpectrumFileOptions& options) {
  if (!table.columns.empty()) return named_columns(table, options);
  if (table.rows.front().cells.size() != 2)
    return in_file(table, std::string(expected_columns) + ", or two columns without names");
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

}  // namespace

Result<desk::MeasuredSpectrum> read_spectrum_file(const std::filesystem::path& path,
                                                  const SpectrumFileOptions& options) {
  const Result<io::CsvTable> table = io::read_csv(path);
  if (!table) return table.errors();
  const Result<Columns> columns = columns_of(*table, options);
  if (!columns) return columns.errors();

  const auto wavelengths_nm = column_of(*table, *columns->wavelength, columns->nm_per_unit, wrong_wavelength);
  if (!wavelengths_nm) return wavelengths_nm.errors();
  const double longest_nm = *std::max_element(wavelengths_nm->begin(), wavelengths_nm->end());
  if (longest_nm < shortest_plausible_last_nm)
    return in_file(*table, "expected wavelengths in nm; the longest is " + format_number(longest_nm) +
                               ": are they micrometres? Then name the column wavelength_um");
  desk::MeasuredSpectrum spectrum;
  for (const double nm : *wavelengths_nm) spectrum.rows.push_back({nm, options.incidence_deg, {}});
  if (columns->angle) {
    const auto angles_deg = column_of(*table, *columns->angle, 1, wrong_angle);
    if (!angles_deg) return angles_deg.errors();
    for (std::size_t i = 0; i < angles_deg->size(); ++i) spectrum.rows[i].incidence_deg = (*angles_deg)[i];
  }
  for (const Share& share : columns->shares) {
    const auto wrong = [&](double value) -> std::string {
      if (value >= least_share && value <= most_share) return "";
      const std::string got = share.percent ? format_number(value * 100, 6) + " %" : format_number(value, 6);
      return "expected a share of the incident light, 0..1, got " + got +
             (share.percent ? "" : ": is it in percent? (--percent, or a column name such as R_percent)");
    };
    const auto values = column_of(*table, share.column, share.percent ? 0.01 : 1, wrong);
    if (!values) return values.errors();
    spectrum.quantities.push_back(share.quantity);
    for (std::size_t i = 0; i < values->size(); ++i) spectrum.rows[i].shares.push_back((*values)[i]);
  }
  return spectrum;
}

}  // namespace shabon::api
