#include "shabon/io/svg_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shabon/base/text.h"

namespace shabon::io {

namespace svg {

namespace {

constexpr double pixels_per_tick_x = 85, pixels_per_tick_y = 48;
constexpr double minor_length = 3, least_minor_gap = 6;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::string_view ink = "#333333", grid_grey = "#e4e4e4";
constexpr double y_label_x = 18;

void widen(Range& range, double value) {
  if (!std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

// The range to draw: the axis's own limits, else the data's, with some room where asked; never empty.
Range find_range(const ChartAxis& axis, Range data, double room) {
  if (!(data.low <= data.high)) data = {0, 1};
  const double margin = room * (data.high - data.low);
  Range range{axis.low.value_or(data.low >= 0 && data.low <= margin ? std::min(data.low, 0.0) : data.low - margin),
              axis.high.value_or(data.high + margin)};
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return {};
  if (range.low > range.high) std::swap(range.low, range.high);
  // Nearly equal limits would leave no distinct numbers for the ticks.
  const double least = std::max(std::abs(range.low), std::abs(range.high)) * 1e-12;
  if (range.high - range.low <= least) {
    const double half = range.low == 0 ? 0.5 : std::abs(range.low) * 0.5;
    range = {range.low - half, range.high + half};
  }
  return std::isfinite(range.high - range.low) ? range : Range{};
}

void widen(Range& x, Range& y, const ChartPlot& plot) {
  for (const ChartSeries& series : plot.series)
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
      widen(x, series.x[i]);
      widen(y, series.y[i]);
    }
  for (const ChartRule& rule : plot.rules) widen(y, rule.at);
  if (!plot.picture) return;
  widen(x, plot.picture->x_low);
  widen(x, plot.picture->x_high);
  widen(y, plot.picture->y_low);
  widen(y, plot.picture->y_high);
}

std::vector<double> ticks_of(Range range, double length, double per_tick) {
  return nice_ticks(range.low, range.high, std::max(2, static_cast<int>(length / per_tick)));
}

std::string tick_label(double value) { return format_number(value, 12); }

// The unlabelled ticks between the labelled ones: quarters of a step of 2, fifths of one of 1 or 5.
std::vector<double> minor_ticks(const std::vector<double>& ticks, Range range, double length) {
  if (ticks.size() < 2) return {};
  const double step = ticks[1] - ticks[0];
  const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const int parts = std::lround(digit) == 2 ? 4 : 5;
  if (!(step / parts / (range.high - range.low) * length >= least_minor_gap)) return {};
  std::vector<double> minor;
  for (int i = -parts; i <= parts * static_cast<int>(ticks.size()); ++i) {
    const double value = ticks[0] + i * step / parts;
    if (i % parts != 0 && value >= range.low && value <= range.high) minor.push_back(value);
  }
  return minor;
}

}  // namespace

Range x_range(const Chart& chart) {
  Range x{infinity, -infinity}, y = x;
  widen(x, y, chart);
  for (const ChartPlot& plot : chart.further) widen(x, y, plot);
  for (const ChartStrip& strip : chart.strips) {
    widen(x, strip.low);
    widen(x, strip.high);
  }
  return find_range(chart.x, x, 0);
}

Range y_range(const ChartPlot& plot) {
  Range x{infinity, -infinity}, y = x;
  widen(x, y, plot);
  return find_range(plot.y, y, plot.picture ? 0 : 0.05);
}

bool is_drawn(const ChartPlot& plot) { return !plot.series.empty() || plot.picture || !plot.rules.empty(); }

std::string x_grid(const Frame& frame) {
  std::string svg;
  for (const double tick : ticks_of(frame.x, frame.width(), pixels_per_tick_x))
    svg += line(frame.at_x(tick), frame.top, frame.at_x(tick), frame.bottom, grid_grey, 1);
  return svg;
}

std::string x_ticks(const Frame& frame, double axis_y, bool numbers) {
  std::string svg;
  const std::vector<double> ticks = ticks_of(frame.x, frame.width(), pixels_per_tick_x);
  for (const double tick : ticks) {
    const double x = frame.at_x(tick);
    svg += line(x, axis_y, x, axis_y + tick_length, ink, 1);
    if (numbers)
      svg += text(x, axis_y + tick_length + text_size + 1, tick_label(tick), {.size = small_size, .anchor = "middle"});
  }
  for (const double tick : minor_ticks(ticks, frame.x, frame.width()))
    svg += line(frame.at_x(tick), axis_y, frame.at_x(tick), axis_y + minor_length, ink, 0.75);
  return svg;
}

double x_label_room(const Frame& frame) {
  constexpr double widest_digits = 1.1;  // of the average letter
  double room = 0;
  for (const double tick : ticks_of(frame.x, frame.width(), pixels_per_tick_x))
    room =
        std::max(room, frame.at_x(tick) + widest_digits * text_width(tick_label(tick), small_size) / 2 - frame.right);
  return room;
}

std::string y_axis(const Frame& frame, const std::string& label, bool grid) {
  std::string svg;
  const std::vector<double> ticks = ticks_of(frame.y, frame.height(), pixels_per_tick_y);
  for (const double tick : ticks) {
    const double y = frame.at_y(tick);
    if (grid) svg += line(frame.left, y, frame.right, y, grid_grey, 1);
    svg += line(frame.left - tick_length, y, frame.left, y, ink, 1);
    svg += text(frame.left - tick_length - 4, y + 4, tick_label(tick), {.size = small_size, .anchor = "end"});
  }
  for (const double tick : minor_ticks(ticks, frame.y, frame.height()))
    svg += line(frame.left - minor_length, frame.at_y(tick), frame.left, frame.at_y(tick), ink, 0.75);
  return svg + text(y_label_x, (frame.top + frame.bottom) / 2, label,
                    {.size = text_size, .anchor = "middle", .turn_deg = -90});
}

}  // namespace svg

std::vector<double> nice_ticks(double low, double high, int count) {
  constexpr int most_ticks = 1000;
  if (!(low < high) || !std::isfinite(high - low) || count < 1) return {};
  const double rough = (high - low) / std::min(count, most_ticks);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  if (!(power > 0)) return {};
  const double digit = rough / power;
  const double step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
  const double slack = 1e-9;  // of a step: limits that are ticks themselves count as inside
  std::vector<double> ticks;
  const double first = std::ceil(low / step - slack), last = std::floor(high / step + slack);
  for (int i = 0; i <= 2 * most_ticks && first + i <= last; ++i) {
    // Tenths of a step have no exact double; twelve digits remove the dust (0.30000000000000004).
    const double exact = (first + i) * step;
    ticks.push_back(parse_number(format_number(exact, 12)).value_or(exact) + 0.0);
  }
  return ticks;
}

}  // namespace shabon::io
