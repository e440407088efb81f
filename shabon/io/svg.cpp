#include "shabon/io/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shabon/base/text.h"

namespace shabon::io {

namespace {

// Lengths in px of the drawing; 13 px text reads well on a screen and at 3 inches' width in print.
constexpr double text_size = 13, title_size = 17, small_size = 12;
constexpr double margin_left = 72, margin_right = 24, margin_top = 20, margin_bottom = 54;
constexpr double title_line = 24, subtitle_line = 20, legend_line = 22;
constexpr double strip_height = 26, strip_gap = 8, strip_label_line = 18;
constexpr double tick_length = 5, legend_stroke = 26, legend_gap = 18;
constexpr double pixels_per_tick_x = 85, pixels_per_tick_y = 48;
constexpr double letter_width = 0.56;  // of the text size, an average over Latin letters in Helvetica and its kin
constexpr int most_ticks = 1000;

// Okabe and Ito, "Color Universal Design" (2008), without the yellow, which is too light for a line on white.
constexpr std::array<std::string_view, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#000000"};

struct Range {
  double low = 0, high = 1;
};

struct Frame {  // the rectangle the lines are drawn in
  double left = 0, top = 0, right = 0, bottom = 0;
  Range x, y;
  double at_x(double value) const { return left + (value - x.low) / (x.high - x.low) * (right - left); }
  double at_y(double value) const { return bottom - (value - y.low) / (y.high - y.low) * (bottom - top); }
};

std::string escape(std::string_view text) {
  std::string safe;
  for (const std::string& character : utf8_characters(text)) {
    if (character == "&") {
      safe += "&amp;";
    } else if (character == "<") {
      safe += "&lt;";
    } else if (character == ">") {
      safe += "&gt;";
    } else if (character == "\"") {
      safe += "&quot;";
    } else {
      safe += printable(character);  // XML forbids control characters and broken UTF-8
    }
  }
  return safe;
}

std::string px(double value) { return format_number(std::round(value * 100) / 100 + 0.0); }

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escape(value) + "\"";
}

std::string text_at(double x, double y, std::string_view text, double size, std::string_view anchor,
                    std::string_view more = "") {
  return "<text" + attribute("x", px(x)) + attribute("y", px(y)) + attribute("font-size", px(size)) +
         attribute("text-anchor", anchor) + std::string(more) + ">" + escape(text) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, std::string_view stroke, double width) {
  return "<line" + attribute("x1", px(x1)) + attribute("y1", px(y1)) + attribute("x2", px(x2)) +
         attribute("y2", px(y2)) + attribute("stroke", stroke) + attribute("stroke-width", px(width)) + "/>\n";
}

double text_width(std::string_view text, double size) {
  return letter_width * size * static_cast<double>(utf8_characters(text).size());
}

// The range to draw: the axis's own limits, else the data's, with some room where asked; never empty.
Range find_range(const ChartAxis& axis, double low, double high, double room) {
  if (!(low <= high)) low = 0, high = 1;
  const double margin = room * (high - low);
  Range range{axis.low.value_or(low >= 0 && low <= margin ? std::min(low, 0.0) : low - margin),
              axis.high.value_or(high + margin)};
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

void widen(Range& range, double value) {
  if (!std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

void set_ranges(const Chart& chart, Frame& frame) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range x{infinity, -infinity}, y{infinity, -infinity};
  for (const ChartSeries& series : chart.series)
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
      widen(x, series.x[i]);
      widen(y, series.y[i]);
    }
  for (const ChartStrip& strip : chart.strips) {
    widen(x, strip.low);
    widen(x, strip.high);
  }
  frame.x = find_range(chart.x, x.low, x.high, 0);
  frame.y = find_range(chart.y, y.low, y.high, 0.05);
}

int tick_count(double length, double per_tick) { return std::max(2, static_cast<int>(length / per_tick)); }

std::string tick_label(double value) { return format_number(value, 12); }

std::string draw_x_axis(const Chart& chart, const Frame& frame, double axis_y, bool grid) {
  std::string svg;
  for (double tick : nice_ticks(frame.x.low, frame.x.high, tick_count(frame.right - frame.left, pixels_per_tick_x))) {
    const double x = frame.at_x(tick);
    if (grid) svg += line(x, frame.top, x, frame.bottom, "#e4e4e4", 1);
    svg += line(x, axis_y, x, axis_y + tick_length, "#333333", 1);
    svg += text_at(x, axis_y + tick_length + text_size + 1, tick_label(tick), small_size, "middle");
  }
  return svg + text_at((frame.left + frame.right) / 2, axis_y + 42, chart.x.label, text_size, "middle");
}

std::string draw_y_axis(const Chart& chart, const Frame& frame) {
  std::string svg;
  for (double tick : nice_ticks(frame.y.low, frame.y.high, tick_count(frame.bottom - frame.top, pixels_per_tick_y))) {
    const double y = frame.at_y(tick);
    svg += line(frame.left, y, frame.right, y, "#e4e4e4", 1);
    svg += line(frame.left - tick_length, y, frame.left, y, "#333333", 1);
    svg += text_at(frame.left - tick_length - 4, y + 4, tick_label(tick), small_size, "end");
  }
  const double middle = (frame.top + frame.bottom) / 2;
  const std::string turn = attribute("transform", "translate(18 " + px(middle) + ") rotate(-90)");
  return svg + text_at(0, 0, chart.y.label, text_size, "middle", turn);
}

std::string series_color(const ChartSeries& series, std::size_t index) {
  return series.color.empty() ? std::string(palette[index % palette.size()]) : series.color;
}

std::string stroke_style(const ChartSeries& series, std::size_t index) {
  return attribute("stroke", series_color(series, index)) + attribute("stroke-width", "2") +
         (series.dashed ? attribute("stroke-dasharray", "7 4") : "");
}

// One path; a value that is not finite lifts the pen. A point alone becomes a dot by its round ends.
std::string draw_series(const ChartSeries& series, std::size_t index, const Frame& frame) {
  std::string path;
  bool down = false;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const double x = frame.at_x(series.x[i]), y = frame.at_y(series.y[i]);
    const bool drawable = std::isfinite(x) && std::isfinite(y);
    if (drawable && !down) path += "M" + px(x) + " " + px(y);
    if (drawable) path += "L" + px(x) + " " + px(y);
    down = drawable;
  }
  if (path.empty()) return {};
  return "<path" + attribute("d", path) + stroke_style(series, index) +
         " fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
}

// Entries from left to right, wrapping; moves `y` below them.
std::string draw_legend(const Chart& chart, double left, double right, double& y) {
  std::string svg;
  double x = left;
  bool any = false;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const ChartSeries& series = chart.series[i];
    if (series.label.empty()) continue;
    const double width = legend_stroke + 6 + text_width(series.label, small_size);
    if (any && x + width > right) {
      x = left;
      y += legend_line;
    }
    svg += "<line" + attribute("x1", px(x)) + attribute("y1", px(y + 10)) + attribute("x2", px(x + legend_stroke)) +
           attribute("y2", px(y + 10)) + stroke_style(series, i) + " fill=\"none\"/>\n";
    svg += text_at(x + legend_stroke + 6, y + 14, series.label, small_size, "start");
    x += width + legend_gap;
    any = true;
  }
  if (any) y += legend_line + 4;
  return svg;
}

// Neighbours overlap by half a pixel: without it a viewer's smoothing shows hairlines between them.
std::string draw_strip(const ChartStrip& strip, const Frame& frame, double& y) {
  std::string svg;
  if (!strip.label.empty()) {
    svg += text_at(frame.left, y + small_size, strip.label, small_size, "start");
    y += strip_label_line;
  }
  const auto count = static_cast<double>(strip.colors.size());
  for (std::size_t i = 0; i < strip.colors.size(); ++i) {
    const double step = (strip.high - strip.low) / count;
    const double a = frame.at_x(strip.low + step * static_cast<double>(i));
    const double b = frame.at_x(strip.low + step * static_cast<double>(i + 1));
    const double left = std::clamp(std::min(a, b), frame.left, frame.right);
    const double right = std::clamp(std::max(a, b) + (i + 1 < strip.colors.size() ? 0.5 : 0), frame.left, frame.right);
    if (right > left)
      svg += "<rect" + attribute("x", px(left)) + attribute("y", px(y)) + attribute("width", px(right - left)) +
             attribute("height", px(strip_height)) + attribute("fill", strip.colors[i]) + "/>\n";
  }
  y += strip_height + strip_gap;
  return svg;
}

double strips_height(const Chart& chart) {
  double height = 0;
  for (const ChartStrip& strip : chart.strips)
    height += strip_height + strip_gap + (strip.label.empty() ? 0 : strip_label_line);
  return height;
}

std::string opening(int width, int height) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
         attribute("width", w) + attribute("height", h) + attribute("viewBox", "0 0 " + w + " " + h) +
         " font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" fill=\"#1a1a1a\" stroke=\"none\">\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::string draw_titles(const Chart& chart, double left, double& y) {
  std::string svg;
  if (!chart.title.empty()) {
    svg += text_at(left, y + title_size - 3, chart.title, title_size, "start", attribute("font-weight", "bold"));
    y += title_line;
  }
  if (!chart.subtitle.empty()) {
    svg += text_at(left, y + text_size - 2, chart.subtitle, text_size, "start", attribute("fill", "#555555"));
    y += subtitle_line;
  }
  return svg;
}

// The lines with their axes. Limits of the caller's own may cut lines off; otherwise there is nothing to clip, and some
// simple viewers lose what is clipped.
std::string draw_plot(const Chart& chart, const Frame& frame) {
  std::string svg = draw_y_axis(chart, frame);
  const std::string box = attribute("x", px(frame.left)) + attribute("y", px(frame.top)) +
                          attribute("width", px(frame.right - frame.left)) +
                          attribute("height", px(frame.bottom - frame.top));
  const bool clip = chart.x.low || chart.x.high || chart.y.low || chart.y.high;
  if (clip) svg += "<clipPath id=\"plot\"><rect" + box + "/></clipPath>\n";
  svg += clip ? "<g clip-path=\"url(#plot)\">\n" : "<g>\n";
  for (std::size_t i = 0; i < chart.series.size(); ++i) svg += draw_series(chart.series[i], i, frame);
  return svg + "</g>\n<rect" + box + " fill=\"none\" stroke=\"#333333\"/>\n";
}

}  // namespace

std::vector<double> nice_ticks(double low, double high, int count) {
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

std::string chart_svg(const Chart& chart) {
  const int width = std::max(chart.width_px, 200), height = std::max(chart.height_px, 150);
  Frame frame{margin_left, margin_top, width - margin_right, 0, {}, {}};
  set_ranges(chart, frame);
  std::string svg = opening(width, height);
  double y = 12;
  svg += draw_titles(chart, frame.left, y);
  svg += draw_legend(chart, frame.left, frame.right, y);
  frame.top = std::max(y, margin_top);
  const double strips = strips_height(chart);
  const double axis_y = height - margin_bottom;
  const bool lines = !chart.series.empty();
  // Lines get what the strips below them leave, at least a little.
  frame.bottom = lines ? std::max(axis_y - strips - (strips > 0 ? strip_gap : 0), frame.top + 40) : frame.top;
  svg += draw_x_axis(chart, frame, strips > 0 ? std::max(axis_y, frame.bottom) : frame.bottom, lines);
  if (lines) svg += draw_plot(chart, frame);
  y = lines ? frame.bottom + strip_gap : std::max(frame.top, axis_y - strips);
  for (const ChartStrip& strip : chart.strips) svg += draw_strip(strip, frame, y);
  return svg + "</svg>\n";
}

}  // namespace shabon::io
