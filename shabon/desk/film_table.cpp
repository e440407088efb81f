#include "shabon/desk/film_table.h"

#include <algorithm>

#include "shabon/base/parallel.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/reference/ellipsometry.h"
#include "shabon/optics/reference/stack.h"
#include "shabon/optics/reference/stack_model.h"

namespace shabon::desk {

namespace {

// Everything that a row may be asked for; only what the details ask for is computed.
struct Point {
  optics::Powers powers;
  optics::Amplitudes amplitudes;
  optics::Phases phases;
  optics::Ellipsometry reflected, transmitted;
};

struct Column {
  const char* name;
  FilmQuantity quantity;
  double (*value)(const Point&);
};

constexpr Column power_columns[] = {
    {"R_s", FilmQuantity::share, [](const Point& p) { return p.powers.R_s; }},
    {"R_p", FilmQuantity::share, [](const Point& p) { return p.powers.R_p; }},
    {"T_s", FilmQuantity::share, [](const Point& p) { return p.powers.T_s; }},
    {"T_p", FilmQuantity::share, [](const Point& p) { return p.powers.T_p; }},
    {"A_s", FilmQuantity::share, [](const Point& p) { return 1 - p.powers.R_s - p.powers.T_s; }},
    {"A_p", FilmQuantity::share, [](const Point& p) { return 1 - p.powers.R_p - p.powers.T_p; }},
};

constexpr Column amplitude_columns[] = {
    {"r_s_re", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.r_s.real(); }},
    {"r_s_im", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.r_s.imag(); }},
    {"r_p_re", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.r_p.real(); }},
    {"r_p_im", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.r_p.imag(); }},
    {"t_s_re", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.t_s.real(); }},
    {"t_s_im", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.t_s.imag(); }},
    {"t_p_re", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.t_p.real(); }},
    {"t_p_im", FilmQuantity::amplitude, [](const Point& p) { return p.amplitudes.t_p.imag(); }},
    {"r_s_deg", FilmQuantity::degrees, [](const Point& p) { return p.phases.r_s_deg; }},
    {"r_p_deg", FilmQuantity::degrees, [](const Point& p) { return p.phases.r_p_deg; }},
    {"t_s_deg", FilmQuantity::degrees, [](const Point& p) { return p.phases.t_s_deg; }},
    {"t_p_deg", FilmQuantity::degrees, [](const Point& p) { return p.phases.t_p_deg; }},
};

constexpr Column ellipsometry_columns[] = {
    {"psi_deg", FilmQuantity::degrees, [](const Point& p) { return p.reflected.psi_deg; }},
    {"delta_deg", FilmQuantity::degrees, [](const Point& p) { return p.reflected.delta_deg; }},
    {"psi_t_deg", FilmQuantity::degrees, [](const Point& p) { return p.transmitted.psi_deg; }},
    {"delta_t_deg", FilmQuantity::degrees, [](const Point& p) { return p.transmitted.delta_deg; }},
};

std::vector<Column> fixed_columns(const FilmTableDetails& details) {
  std::vector<Column> columns(std::begin(power_columns), std::end(power_columns));
  if (details.amplitudes) columns.insert(columns.end(), std::begin(amplitude_columns), std::end(amplitude_columns));
  if (details.ellipsometry)
    columns.insert(columns.end(), std::begin(ellipsometry_columns), std::end(ellipsometry_columns));
  return columns;
}

Status check(const optics::Stack& stack, optics::Interference interference, const FilmTableDetails& details) {
  const Status computable = check_computable(stack, interference);
  if (!computable) return computable;
  if (!details.amplitudes && !details.ellipsometry && !details.layers) return Done{};
  const std::string what = details.amplitudes     ? "amplitudes"
                           : details.ellipsometry ? "psi and delta"
                                                  : "what each layer absorbs";
  if (interference != optics::Interference::airy)
    return fail(Failure::content, std::string(optics::name_of(interference)) + " does not tell " + what +
                                      "; airy, the exact model, does");
  const auto coherent = [](const optics::Layer& layer) { return layer.coherent; };
  if ((details.amplitudes || details.ellipsometry) && !std::all_of(stack.layers.begin(), stack.layers.end(), coherent))
    return fail(Failure::content, "behind an incoherent layer there are no " + what + ", only powers");
  return Done{};
}

class Filler {
 public:
  Filler(const optics::Stack& stack, optics::Interference interference, const FilmTableDetails& details,
         FilmTable& table)
      : stack_(stack), interference_(interference), details_(details), table_(table), fixed_(fixed_columns(details)) {
    for (const Column& column : fixed_) table.columns.push_back({column.name, column.quantity, {}});
    for (std::size_t j = 1; details.layers && j <= stack.layers.size(); ++j)
      for (const char* name : {"A_s_", "A_p_"})
        table.columns.push_back({name + std::to_string(j), FilmQuantity::layer_share, {}});
    for (FilmColumn& column : table.columns) column.values.resize(table.rows());
  }

  void fill(std::size_t row) {
    const optics::Incidence incidence =
        optics::incidence_from(Degrees(table_.incidence_deg[row / table_.wavelengths_nm.size()]));
    const double wavelength_nm = table_.wavelengths_nm[row % table_.wavelengths_nm.size()];
    const optics::ResolvedStack resolved = optics::resolve(stack_, wavelength_nm);
    Point point;
    point.powers = optics::model_powers(resolved, interference_, incidence, wavelength_nm);
    if (details_.layers) {
      const optics::StackPowers all = optics::stack_powers(resolved, incidence, wavelength_nm);
      for (std::size_t j = 0; j < stack_.layers.size(); ++j) {
        table_.columns[fixed_.size() + 2 * j].values[row] = all.A_s[j];
        table_.columns[fixed_.size() + 2 * j + 1].values[row] = all.A_p[j];
      }
    }
    if (details_.amplitudes || details_.ellipsometry) {
      point.amplitudes = optics::stack_amplitudes(resolved, incidence, wavelength_nm);
      point.phases = optics::phases(point.amplitudes);
      point.reflected = optics::ellipsometry(point.amplitudes);
      point.transmitted = optics::transmission_ellipsometry(point.amplitudes);
    }
    for (std::size_t c = 0; c < fixed_.size(); ++c) table_.columns[c].values[row] = fixed_[c].value(point);
  }

 private:
  const optics::Stack& stack_;
  optics::Interference interference_;
  const FilmTableDetails& details_;
  FilmTable& table_;
  std::vector<Column> fixed_;
};

}  // namespace

std::size_t film_table_columns(const optics::Stack& stack, const FilmTableDetails& details) {
  return fixed_columns(details).size() + (details.layers ? 2 * stack.layers.size() : 0);
}

Result<FilmTable> film_table(const optics::Stack& stack, optics::Interference interference,
                             std::span<const double> incidence_deg, std::span<const double> wavelengths_nm,
                             const FilmTableDetails& details) {
  const Status checked = check(stack, interference, details);
  if (!checked) return checked.errors();
  FilmTable table;
  table.incidence_deg.assign(incidence_deg.begin(), incidence_deg.end());
  table.wavelengths_nm.assign(wavelengths_nm.begin(), wavelengths_nm.end());
  Filler filler(stack, interference, details, table);
  parallel_for(table.rows(), 0, [&](std::size_t row) { filler.fill(row); });
  return table;
}

}  // namespace shabon::desk
