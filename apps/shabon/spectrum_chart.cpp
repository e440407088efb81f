#include "spectrum_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shabon/base/text.h"
#include "shabon/io/svg.h"

namespace shabon::app {

namespace {

// Absorption below this is rounding, and no line of its own.
constexpr double visible_absorption = 1e-9;

constexpr int width_px = 800, plot_height_px = 430, small_plot_height_px = 300;
constexpr std::size_t most_legend_entries = 8, most_plots = 24;

// Columns that share one axis, where there is room for one line of each.
struct Plot {
  desk::FilmQuantity quantity;
  const char *heading, *label;
};

constexpr Plot plots[] = {
    {desk::FilmQuantity::share, "", "share of the light"},
    {desk::FilmQuantity::layer_share, "absorbed in each layer", "share of the light"},
    {desk::FilmQuantity::amplitude, "amplitudes", "ratio of electric fields"},
    {desk::FilmQuantity::degrees, "phases and ellipsometry", "degrees"},
};

const char* axis_label(desk::FilmQuantity quantity) {
  for (const Plot& plot : plots)
    if (plot.quantity == quantity) return plot.label;
  return "";
}

bool is_drawn(const desk::FilmColumn& column) {
  if (!column.name.starts_with("A")) return true;
  return std::any_of(column.values.begin(), column.values.end(),
                     [](double value) { return std::abs(value) > visible_absorption; });
}

bool is_p(const std::string& name) { return name.ends_with("_p") || name.find("_p_") != std::string::npos; }

// What s and p have in common: "R" of R_s and R_p, "r_re" of r_s_re and r_p_re.
std::string family(const std::string& name) {
  for (const char* polarisation : {"_s", "_p"}) {
    const std::string inside = std::string(polarisation) + "_";
    if (name.ends_with(polarisation)) return name.substr(0, name.size() - 2);
    if (const std::size_t at = name.find(inside); at != std::string::npos)
      return name.substr(0, at) + name.substr(at + 2);
  }
  return name;
}

std::string family_heading(const std::string& family) {
  return family == "R" ? "R, reflected" : family == "T" ? "T, transmitted" : family == "A" ? "A, absorbed" : family;
}

std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  return order;
}

void add_over_angle(io::ChartSeries& line, const desk::FilmTable& film, const desk::FilmColumn& column) {
  for (const std::size_t a : rising_order(film.incidence_deg)) {
    line.x.push_back(film.incidence_deg[a]);
    line.y.push_back(column.values[film.row(a, 0)]);
  }
}

void add_over_wavelength(io::ChartSeries& line, const desk::FilmTable& film, const desk::FilmColumn& column,
                         std::size_t a) {
  for (const std::size_t w : rising_order(film.wavelengths_nm)) {
    line.x.push_back(film.wavelengths_nm[w]);
    line.y.push_back(column.values[film.row(a, w)]);
  }
}

// A single angle or wavelength: one line a column, all of a quantity in one plot.
std::vector<io::ChartPlot> single_plots(const desk::FilmTable& film, bool over_angle) {
  std::vector<io::ChartPlot> drawn;
  for (const Plot& kind : plots) {
    io::ChartPlot plot;
    plot.heading = kind.heading;
    plot.y.label = kind.label;
    for (const desk::FilmColumn& column : film.columns) {
      if (column.quantity != kind.quantity || !is_drawn(column)) continue;
      io::ChartSeries& line = plot.series.emplace_back();
      line.label = column.name;
      line.dashed = is_p(column.name);
      if (over_angle) {
        add_over_angle(line, film, column);
      } else {
        add_over_wavelength(line, film, column, 0);
      }
    }
    if (!plot.series.empty()) drawn.push_back(std::move(plot));
  }
  return drawn;
}

// Several angles: a plot for each quantity, in it a colour for each angle; p is dashed. Of many angles the legend lists
// some, the first and the last among them.
std::vector<io::ChartPlot> plots_of_angles(const desk::FilmTable& film) {
  std::vector<io::ChartPlot> drawn;
  const std::vector<std::size_t> order = rising_order(film.incidence_deg);
  const std::size_t every = (order.size() + most_legend_entries - 1) / most_legend_entries;
  std::vector<std::string> families;
  for (const desk::FilmColumn& column : film.columns) {
    if (!is_drawn(column)) continue;
    const auto known = std::find(families.begin(), families.end(), family(column.name));
    const auto at = static_cast<std::size_t>(known - families.begin());
    if (known == families.end()) {
      families.push_back(family(column.name));
      io::ChartPlot& plot = drawn.emplace_back();
      plot.heading = family_heading(families.back());
      plot.y.label = axis_label(column.quantity);
    }
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      io::ChartSeries& line = drawn[at].series.emplace_back();
      line.color = io::sequence_color(rank, order.size());
      line.dashed = is_p(column.name);
      const bool listed = &column == &film.columns.front() && (rank % every == 0 || rank + 1 == order.size());
      if (listed) line.label = format_number(film.incidence_deg[order[rank]], 4) + "\u00B0";
      add_over_wavelength(line, film, column, order[rank]);
    }
  }
  return drawn;
}

std::string subtitle_of(const SpectrumTable& table, bool over_angle) {
  const desk::FilmTable& film = table.film;
  std::string subtitle = over_angle ? "at " + format_number(film.wavelengths_nm[0]) + " nm"
                         : film.incidence_deg.size() == 1
                             ? format_number(film.incidence_deg[0]) + "\u00B0 from the normal"
                             : "angles of incidence by colour; s solid, p dashed";
  if (table.reversed) subtitle += ", light from the other side";
  return subtitle;
}

}  // namespace

std::string spectrum_svg(const SpectrumTable& table) {
  const desk::FilmTable& film = table.film;
  const bool over_angle = film.wavelengths_nm.size() == 1 && film.incidence_deg.size() > 1;
  const bool several = !over_angle && film.incidence_deg.size() > 1;
  io::Chart chart;
  chart.title = table.expression;
  chart.subtitle = subtitle_of(table, over_angle);
  chart.x.label = over_angle ? "angle of incidence (degrees)" : "wavelength (nm)";
  chart.further = several ? plots_of_angles(film) : single_plots(film, over_angle);
  if (chart.further.size() > most_plots) {
    chart.notes = {fmt::format("{} further plots are left out.", chart.further.size() - most_plots)};
    chart.further.resize(most_plots);
  }
  const int count = static_cast<int>(chart.further.size());
  chart.width_px = width_px;
  chart.height_px = 70 + count * (several && count > 1 ? small_plot_height_px : plot_height_px);
  return io::chart_svg(chart);
}

}  // namespace shabon::app
