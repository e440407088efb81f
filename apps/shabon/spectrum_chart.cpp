#include "spectrum_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shabon/base/text.h"
#include "shabon/io/svg.h"

namespace shabon::app {

namespace {

// Absorption below this is rounding, and no line of its own.
constexpr double visible_absorption = 1e-9;

constexpr int plot_height_px = 430;

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

bool is_drawn(const desk::FilmColumn& column) {
  if (!column.name.starts_with("A")) return true;
  return std::any_of(column.values.begin(), column.values.end(),
                     [](double value) { return std::abs(value) > visible_absorption; });
}

std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  return order;
}

io::ChartSeries series(const desk::FilmColumn& column) {
  io::ChartSeries result;
  result.label = column.name;
  result.dashed = column.name.ends_with("_p") || column.name.find("_p_") != std::string::npos;
  return result;
}

void add_over_angle(io::ChartPlot& plot, const desk::FilmTable& film, const desk::FilmColumn& column) {
  io::ChartSeries& line = plot.series.emplace_back(series(column));
  for (const std::size_t a : rising_order(film.incidence_deg)) {
    line.x.push_back(film.incidence_deg[a]);
    line.y.push_back(column.values[film.row(a, 0)]);
  }
}

void add_over_wavelength(io::ChartPlot& plot, const desk::FilmTable& film, const desk::FilmColumn& column,
                         std::size_t a) {
  io::ChartSeries& line = plot.series.emplace_back(series(column));
  if (film.incidence_deg.size() > 1) line.label += " " + format_number(film.incidence_deg[a], 4) + "\u00B0";
  for (const std::size_t w : rising_order(film.wavelengths_nm)) {
    line.x.push_back(film.wavelengths_nm[w]);
    line.y.push_back(column.values[film.row(a, w)]);
  }
}

io::ChartPlot plot_of(const Plot& kind, const desk::FilmTable& film, bool over_angle) {
  io::ChartPlot plot;
  plot.heading = kind.heading;
  plot.y.label = kind.label;
  for (const desk::FilmColumn& column : film.columns) {
    if (column.quantity != kind.quantity || !is_drawn(column)) continue;
    if (over_angle) {
      add_over_angle(plot, film, column);
      continue;
    }
    for (std::size_t a = 0; a < film.incidence_deg.size(); ++a) add_over_wavelength(plot, film, column, a);
  }
  return plot;
}

}  // namespace

std::string spectrum_svg(const SpectrumTable& table) {
  const desk::FilmTable& film = table.film;
  const bool over_angle = film.wavelengths_nm.size() == 1 && film.incidence_deg.size() > 1;
  io::Chart chart;
  chart.title = table.expression;
  chart.subtitle = over_angle                       ? "at " + format_number(film.wavelengths_nm[0]) + " nm"
                   : film.incidence_deg.size() == 1 ? format_number(film.incidence_deg[0]) + "\u00B0 from the normal"
                                                    : "";
  if (table.reversed) chart.subtitle += std::string(chart.subtitle.empty() ? "" : ", ") + "light from the other side";
  chart.x.label = over_angle ? "angle of incidence (degrees)" : "wavelength (nm)";
  for (const Plot& kind : plots) {
    io::ChartPlot plot = plot_of(kind, film, over_angle);
    if (kind.quantity == desk::FilmQuantity::share)
      static_cast<io::ChartPlot&>(chart) = std::move(plot);
    else if (!plot.series.empty())
      chart.further.push_back(std::move(plot));
  }
  chart.height_px += static_cast<int>(chart.further.size()) * plot_height_px;
  return io::chart_svg(chart);
}

}  // namespace shabon::app
