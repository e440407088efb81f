// shabon compare as a chart.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compare_report.h"
#include "shabon/base/text.h"
#include "shabon/color/gamut.h"
#include "shabon/color/rgb.h"

namespace shabon::app {

namespace {

constexpr int width_px = 1000, strip_height_px = 24;
constexpr double enlarged_to = 5;  // CIEDE2000: what is plain to see, and what most shortcuts stay below

// Colours and dashes that the colour-blind can tell apart: M. Okabe, K. Ito, Color Universal Design (2008).
constexpr std::array<std::string_view, 8> line_colors = {"#0072b2", "#d55e00", "#000000", "#009e73",
                                                         "#cc79a7", "#56b4e9", "#999999", "#e69f00"};

// What brings the brightest exact colour to Y = 1, unless a brightness was asked for.
double display_factor(const CompareReport& report) {
  if (report.brightness != 1) return report.brightness;
  double largest = 0;
  for (const color::Xyz& colour : report.comparison.exact) largest = std::max(largest, colour.y);
  return largest > 0 ? 1 / largest : 1;
}

io::Rgb8 shown(color::Xyz colour, double factor) {
  const color::LinearRgb linear = color::xyz_to_linear_srgb({colour.x * factor, colour.y * factor, colour.z * factor});
  return color::to_bytes(color::encode_srgb(color::map_to_srgb_gamut(linear)));
}

io::ChartStrip strip(const CompareReport& report, std::string_view name, const std::vector<color::Xyz>& colors,
                     double factor) {
  const std::vector<double>& thicknesses_nm = report.sweep.thicknesses_nm;
  const double half = thicknesses_nm.size() < 2 ? 0.5 : (thicknesses_nm[1] - thicknesses_nm[0]) / 2;
  io::ChartStrip result;
  result.label = name;
  result.low = thicknesses_nm.front() - half;
  result.high = thicknesses_nm.back() + half;
  for (const color::Xyz& colour : colors) result.colors.push_back(shown(colour, factor));
  return result;
}

// The same lines near zero, where they leave the plot.
void add_enlarged(io::Chart& chart) {
  const auto leaves = [](const io::ChartSeries& line) {
    return std::any_of(line.y.begin(), line.y.end(), [](double y) { return y > enlarged_to; });
  };
  if (std::none_of(chart.series.begin(), chart.series.end(), leaves)) return;
  io::ChartPlot& plot = chart.further.emplace_back();
  plot.heading = "the same, enlarged";
  plot.y = {"CIEDE2000", 0.0, enlarged_to};
  plot.series = chart.series;
  for (io::ChartSeries& line : plot.series) line.label.clear();
}

}  // namespace

io::Chart compare_chart(const CompareReport& report) {
  const double factor = display_factor(report);
  io::Chart chart;
  chart.title = "Shortcuts and the exact colour: " + title_text(report.film);
  chart.subtitle = compare_conditions(report);
  chart.x = {thickness_label(report.film), report.sweep.thicknesses_nm.front(), report.sweep.thicknesses_nm.back()};
  chart.heading = "difference from the exact colour";
  chart.y = {"CIEDE2000", 0.0, {}};
  chart.strips.push_back(strip(report, "exact", report.comparison.exact, factor));
  for (std::size_t i = 0; i < report.comparison.shortcuts.size(); ++i) {
    const desk::ShortcutSeries& series = report.comparison.shortcuts[i];
    if (!series.unfit.empty()) {
      chart.notes.push_back(fmt::format("Without {}: it {}.", series.shortcut->name, series.unfit));
      continue;
    }
    chart.strips.push_back(strip(report, series.shortcut->name, series.colors, factor));
    io::ChartSeries& line = chart.series.emplace_back();
    line.label = series.shortcut->name;
    line.color = line_colors[i % line_colors.size()];
    line.dashed = i % 2 == 1;
    line.width_px = 1.5;
    line.x = report.sweep.thicknesses_nm;
    line.y = series.differences;
  }
  chart.notes.push_back(
      fmt::format("Strips: \u00D7 {}, colours beyond sRGB mapped into it.", format_number(factor, 3)));
  chart.width_px = width_px;
  chart.strip_height_px = strip_height_px;
  chart.height_px = 0;
  add_enlarged(chart);
  return chart;
}

}  // namespace shabon::app
