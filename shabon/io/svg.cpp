// The layout of a chart: titles, legend, strips, plots, the horizontal axis and the notes, from top to bottom.
#include "shabon/io/svg.h"

#include <algorithm>
#include <cmath>

#include "shabon/io/svg_axes.h"
#include "shabon/io/svg_elements.h"
#include "shabon/io/svg_plot.h"

namespace shabon::io {

namespace {

using namespace svg;

constexpr double margin_left = 72, margin_right = 24, margin_top = 12, margin_bottom = 12;
constexpr double title_size = 17, title_line = 24, subtitle_line = 20, note_line = 16;
constexpr double strip_gap = 8, strip_label_line = 22, heading_line = 24, plot_gap = 14;
constexpr double least_strip = 8, least_plot = 40;
constexpr double tick_line = 24, axis_label_line = 22, note_gap = 6;
constexpr double end_title_line = 18;

std::string draw_titles(const Chart& chart, double left, double& y) {
  std::string svg;
  if (!chart.title.empty()) {
    svg += text(left, y + title_size - 3, chart.title, {.size = title_size, .bold = true});
    y += title_line;
  }
  if (!chart.subtitle.empty()) {
    svg += text(left, y + text_size - 2, chart.subtitle, {.size = text_size, .fill = "#555555"});
    y += subtitle_line;
  }
  return svg;
}

double above_strip(const ChartStrip& strip) {
  return (strip.label.empty() ? 0 : strip_label_line) + (strip.spans.empty() ? 0 : span_line);
}

double above_plot(const ChartPlot& plot) {
  return (plot.heading.empty() ? 0 : heading_line) + end_label_room(plot) +
         (plot.end_title.empty() ? 0 : end_title_line);
}

std::vector<const ChartPlot*> drawn_plots(const Chart& chart) {
  std::vector<const ChartPlot*> plots;
  if (is_drawn(chart)) plots.push_back(&chart);
  for (const ChartPlot& plot : chart.further)
    if (is_drawn(plot)) plots.push_back(&plot);
  return plots;
}

// What the axis below the plots, its label and the notes take.
double foot_height(const Chart& chart) {
  return tick_line + (chart.spans.empty() ? 0 : span_line) + (chart.x.label.empty() ? 0 : axis_label_line) +
         (chart.notes.empty() ? 0 : note_gap + note_line * static_cast<double>(chart.notes.size())) + margin_bottom;
}

std::string draw_strips(const Chart& chart, Frame& frame, double height, double& y) {
  std::string svg;
  for (std::size_t i = 0; i < chart.strips.size(); ++i) {
    const ChartStrip& strip = chart.strips[i];
    if (!strip.label.empty()) {
      svg += text(frame.left, y + text_size + 2, strip.label, {.size = text_size});
      y += strip_label_line;
    }
    if (!strip.spans.empty()) {
      svg += draw_spans(strip.spans, frame, y + span_line, true);
      y += span_line;
    }
    frame.top = y;
    frame.bottom = y + height;
    svg += draw_strip(strip, frame, "strip-" + std::to_string(i + 1));
    y = frame.bottom + strip_gap;
  }
  return svg;
}

std::string draw_plots(const std::vector<const ChartPlot*>& plots, Frame& frame, double height, double& y) {
  std::string svg;
  for (std::size_t i = 0; i < plots.size(); ++i) {
    const ChartPlot& plot = *plots[i];
    if (!plot.heading.empty()) svg += text(frame.left, y + text_size, plot.heading, {.size = text_size, .bold = true});
    if (!plot.end_title.empty())
      svg += text(frame.right, y + text_size, plot.end_title, {.size = small_size, .anchor = "end"});
    frame.top = y + above_plot(plot);
    frame.bottom = frame.top + height;
    frame.y = y_range(plot);
    const bool grid = !plot.picture;
    if (grid) svg += x_grid(frame);
    svg += y_axis(frame, plot.y.label, grid);
    svg += draw_plot(plot, frame, "plot-" + std::to_string(i + 1));
    if (i + 1 < plots.size()) svg += x_ticks(frame, frame.bottom, false);
    y = frame.bottom + (i + 1 < plots.size() ? plot_gap : 0);
  }
  return svg;
}

std::string draw_foot(const Chart& chart, const Frame& frame, double y) {
  std::string svg = x_ticks(frame, y, true);
  y += tick_line;
  if (!chart.spans.empty()) {
    svg += draw_spans(chart.spans, frame, y, false);
    y += span_line;
  }
  if (!chart.x.label.empty()) {
    svg += text((frame.left + frame.right) / 2, y + text_size, chart.x.label, {.size = text_size, .anchor = "middle"});
    y += axis_label_line;
  }
  y += note_gap;
  for (const std::string& note : chart.notes) {
    svg += text(frame.left, y + small_size, note, {.size = end_text_size, .fill = "#555555"});
    y += note_line;
  }
  return svg;
}

// The heights of each strip and of each plot: what titles and labels leave of the drawing, at least a little.
struct Heights {
  double strip = 0, plot = 0;
};

Heights share_height(const Chart& chart, const std::vector<const ChartPlot*>& plots, double room) {
  const auto strips = static_cast<double>(chart.strips.size()), count = static_cast<double>(plots.size());
  for (const ChartStrip& strip : chart.strips) room -= above_strip(strip) + strip_gap;
  for (const ChartPlot* plot : plots) room -= above_plot(*plot);
  // Below strips alone the axis follows the last one without a gap.
  if (plots.empty()) return {strips > 0 ? std::max((room + strip_gap) / strips, least_strip) : 0, 0};
  room -= plot_gap * (count - 1);
  const double strip = std::max<double>(chart.strip_height_px, least_strip);
  return {strip, std::max((room - strip * strips) / count, least_plot)};
}

// Of all below the legend, for a drawing as high as its contents.
double needed_height(const Chart& chart, const std::vector<const ChartPlot*>& plots) {
  constexpr double usual_plot = 260;
  double height = foot_height(chart);
  for (const ChartStrip& strip : chart.strips)
    height += above_strip(strip) + strip_gap + std::max<double>(chart.strip_height_px, least_strip);
  for (const ChartPlot* plot : plots) height += above_plot(*plot) + usual_plot + plot_gap;
  return height - (plots.empty() ? strip_gap : plot_gap);
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  const int width = std::max(chart.width_px, 200);
  const std::vector<const ChartPlot*> plots = drawn_plots(chart);
  double room_right = margin_right;
  for (const ChartPlot* plot : plots) room_right = std::max(room_right, end_label_room(*plot) + 4);
  Frame frame{{margin_left, 0, width - room_right, 0}, x_range(chart), {}};
  // Of a frame a little wider than it will be.
  frame.right = width - std::max(room_right, std::min(x_label_room(frame) + 4, width / 4.0));
  double y = margin_top;
  std::string svg = draw_titles(chart, frame.left, y);
  svg += draw_legend(chart, frame.left, frame.right, y);
  const int height = chart.height_px == 0 ? static_cast<int>(std::ceil(y + needed_height(chart, plots)))
                                          : std::max(chart.height_px, 150);
  const Heights heights = share_height(chart, plots, height - y - foot_height(chart));
  svg += draw_strips(chart, frame, heights.strip, y);
  svg += draw_plots(plots, frame, heights.plot, y);
  // Strips alone: the axis follows the last one without a gap.
  const bool follows_strip = plots.empty() && !chart.strips.empty();
  svg += draw_foot(chart, frame, follows_strip ? y - strip_gap : y);
  return opening(width, height) + svg + "</svg>\n";
}

std::string sequence_color(std::size_t index, std::size_t count) {
  // Points of viridis (Smith and van der Walt, 2015), without its yellow, which is too light for a line on white.
  constexpr std::array<Rgb8, 4> points{
      Rgb8{0x44, 0x01, 0x54}, {0x3b, 0x52, 0x8b}, {0x21, 0x91, 0x8c}, {0x5e, 0xc9, 0x62}};
  const double share = count < 2 ? 0 : std::min(1.0, static_cast<double>(index) / static_cast<double>(count - 1));
  const double at = share * (points.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(at), points.size() - 2);
  std::string hex = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    const double low = points[first][c], high = points[first + 1][c];
    const auto value = static_cast<unsigned>(std::lround(low + (at - static_cast<double>(first)) * (high - low)));
    for (const unsigned digit : {value / 16, value % 16}) hex += "0123456789abcdef"[digit];
  }
  return hex;
}

}  // namespace shabon::io
