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

bool is_drawn(const SpectrumTable& table, const SpectrumColumn& column) {
  if (!column.name.starts_with("A")) return true;
  return std::any_of(table.powers.begin(), table.powers.end(),
                     [&](const optics::Powers& powers) { return std::abs(column.value(powers)) > visible_absorption; });
}

std::vector<std::size_t> rising_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  return order;
}

io::ChartSeries series(const SpectrumColumn& column) {
  io::ChartSeries result;
  result.label = column.name;
  result.dashed = column.name.ends_with("_p");
  return result;
}

void add_over_angle(io::Chart& chart, const SpectrumTable& table, const SpectrumColumn& column) {
  io::ChartSeries& line = chart.series.emplace_back(series(column));
  for (const std::size_t a : rising_order(table.incidence_deg)) {
    line.x.push_back(table.incidence_deg[a]);
    line.y.push_back(column.value(table.at(a, 0)));
  }
}

void add_over_wavelength(io::Chart& chart, const SpectrumTable& table, const SpectrumColumn& column, std::size_t a) {
  io::ChartSeries& line = chart.series.emplace_back(series(column));
  if (table.incidence_deg.size() > 1) line.label += " " + format_number(table.incidence_deg[a], 4) + "\u00B0";
  for (const std::size_t w : rising_order(table.wavelengths_nm)) {
    line.x.push_back(table.wavelengths_nm[w]);
    line.y.push_back(column.value(table.at(a, w)));
  }
}

}  // namespace

std::string spectrum_svg(const SpectrumTable& table) {
  const bool over_angle = table.wavelengths_nm.size() == 1 && table.incidence_deg.size() > 1;
  io::Chart chart;
  chart.title = table.expression;
  chart.subtitle = over_angle                        ? "at " + format_number(table.wavelengths_nm[0]) + " nm"
                   : table.incidence_deg.size() == 1 ? format_number(table.incidence_deg[0]) + "\u00B0 from the normal"
                                                     : "";
  chart.x.label = over_angle ? "angle of incidence (degrees)" : "wavelength (nm)";
  chart.y.label = "share of the light";
  for (const SpectrumColumn& column : spectrum_columns) {
    if (!is_drawn(table, column)) continue;
    if (over_angle) {
      add_over_angle(chart, table, column);
      continue;
    }
    for (std::size_t a = 0; a < table.incidence_deg.size(); ++a) add_over_wavelength(chart, table, column, a);
  }
  return io::chart_svg(chart);
}

}  // namespace shabon::app
