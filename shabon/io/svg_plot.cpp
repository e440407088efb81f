#include "shabon/io/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shabon::io::svg {

namespace {

constexpr double end_gap = 6, rule_pad = 3;
constexpr double legend_line = 22, legend_stroke = 26, legend_gap = 18;
constexpr double halo_extra = 1.4;

// Okabe and Ito, "Color Universal Design" (2008), without the yellow, which is too light for a line on white.
constexpr std::array<std::string_view, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#56b4e9", "#e69f00", "#000000"};

std::string stroke_style(const ChartSeries& series, std::size_t index) {
  return attribute("stroke", series.color.empty() ? palette[index % palette.size()] : std::string_view(series.color)) +
         attribute("stroke-width", px(series.width_px)) + (series.dashed ? attribute("stroke-dasharray", "7 4") : "");
}

// One path; a value that is not finite lifts the pen. A point alone becomes a dot by its round ends.
std::string path_data(const ChartSeries& series, const Frame& frame) {
  std::string path;
  bool down = false;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const double x = frame.at_x(series.x[i]), y = frame.at_y(series.y[i]);
    const bool drawable = std::isfinite(x) && std::isfinite(y);
    if (drawable && !down) path += "M" + px(x) + " " + px(y);
    if (drawable) path += "L" + px(x) + " " + px(y);
    down = drawable;
  }
  return path;
}

// On a picture a line has light edges, to be seen on black too.
std::string draw_series(const ChartSeries& series, std::size_t index, const Frame& frame, bool halo) {
  const std::string path = path_data(series, frame);
  if (path.empty()) return {};
  constexpr std::string_view ends = " fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
  std::string svg;
  if (halo)
    svg += "<path" + attribute("d", path) + attribute("stroke", "#ffffff") + attribute("stroke-opacity", "0.55") +
           attribute("stroke-width", px(series.width_px + halo_extra)) + std::string(ends);
  return svg + "<path" + attribute("d", path) + stroke_style(series, index) + std::string(ends);
}

struct EndLabel {
  double x = 0, y = 0;  // where it begins
  double turn_deg = 0;  // its direction, clockwise from the right
  double width = 0;

  // Whether `other` begins within the letters of this one or the other way round.
  bool meets(const EndLabel& other) const {
    const double turn = turn_deg * std::numbers::pi / 180;
    const double along = (other.x - x) * std::cos(turn) + (other.y - y) * std::sin(turn);
    const double across = (other.y - y) * std::cos(turn) - (other.x - x) * std::sin(turn);
    return std::abs(across) < end_text_size && std::abs(along) < std::max(width, other.width) + end_gap;
  }
};

// The labels beyond the last points, in the direction in which the lines arrive there.
std::string draw_end_labels(const ChartPlot& plot, const Frame& frame) {
  std::string svg;
  std::vector<EndLabel> placed;
  for (const ChartSeries& series : plot.series) {
    const std::size_t count = std::min(series.x.size(), series.y.size());
    if (series.end_label.empty() || count < 2) continue;
    const double x = frame.at_x(series.x[count - 1]), y = frame.at_y(series.y[count - 1]);
    const double dx = x - frame.at_x(series.x[count - 2]), dy = y - frame.at_y(series.y[count - 2]);
    const double length = std::hypot(dx, dy);
    if (!std::isfinite(length) || !(length > 0) || !std::isfinite(x + y)) continue;
    const double turn = std::atan2(dy, dx);
    // Moved down by a third of the letters' height, so that their middle is on the line.
    const double shift = end_text_size * 0.35;
    const EndLabel label{x + end_gap * dx / length - shift * std::sin(turn),
                         y + end_gap * dy / length + shift * std::cos(turn), turn * 180 / std::numbers::pi,
                         text_width(series.end_label, end_text_size)};
    if (std::any_of(placed.begin(), placed.end(), [&](const EndLabel& other) { return label.meets(other); })) continue;
    svg += text(label.x, label.y, series.end_label, {.size = end_text_size, .turn_deg = label.turn_deg});
    placed.push_back(label);
  }
  return svg;
}

// How many of a plot's lines cross a box.
std::size_t lines_across(const ChartPlot& plot, const Frame& frame, const Box& box) {
  const auto crosses = [&](double x1, double y1, double x2, double y2) {
    // The part of the stretch between the box's left and right (Liang and Barsky), then whether it is above or below.
    double from = 0, to = 1;
    const auto cut = [&](double at, double step, double low, double high) {
      if (step == 0) return at >= low && at <= high;
      const double a = (low - at) / step, b = (high - at) / step;
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
      return from <= to;
    };
    return cut(x1, x2 - x1, box.left, box.right) && cut(y1, y2 - y1, box.top, box.bottom);
  };
  return static_cast<std::size_t>(std::count_if(plot.series.begin(), plot.series.end(), [&](const ChartSeries& series) {
    for (std::size_t i = 1; i < std::min(series.x.size(), series.y.size()); ++i)
      if (crosses(frame.at_x(series.x[i - 1]), frame.at_y(series.y[i - 1]), frame.at_x(series.x[i]),
                  frame.at_y(series.y[i])))
        return true;
    return false;
  }));
}

// Where a rule's label stands: as far right as the fewest lines cross it.
Box label_box(const ChartRule& rule, const ChartPlot& plot, const Frame& frame) {
  constexpr double step = 4, edge = 14;
  const double width = text_width(rule.label, small_size) + 4 * rule_pad, y = frame.at_y(rule.at);
  const double top = y - small_size / 2 - rule_pad, bottom = y + small_size / 2 + rule_pad;
  Box best{};
  std::size_t fewest = plot.series.size() + 1;
  for (double right = frame.right - edge; fewest > 0; right -= step) {
    const Box box{right - width, top, right, bottom};
    if (fewest <= plot.series.size() && box.left < frame.left + edge) break;
    const std::size_t crossed = lines_across(plot, frame, box);
    if (crossed < fewest) best = box, fewest = crossed;
  }
  return best;
}

bool is_seen(const ChartRule& rule, const Frame& frame) {
  const double y = frame.at_y(rule.at);
  return y >= frame.top && y <= frame.bottom;
}

// Below the lines, which no label hides.
std::string draw_rule(const ChartRule& rule, const ChartPlot& plot, const Frame& frame) {
  if (!is_seen(rule, frame)) return {};
  const double y = frame.at_y(rule.at);
  std::string svg = line(frame.left, y, frame.right, y, "#ffffff", 3, attribute("stroke-opacity", "0.55"));
  svg += line(frame.left, y, frame.right, y, "#1a1a1a", 1.4, attribute("stroke-dasharray", "8 4"));
  if (rule.label.empty()) return svg;
  return svg + rectangle(label_box(rule, plot, frame), "#ffffff",
                         attribute("rx", "3") + attribute("stroke", "#333333") + attribute("stroke-width", "0.75"));
}

std::string draw_rule_label(const ChartRule& rule, const ChartPlot& plot, const Frame& frame) {
  if (!is_seen(rule, frame) || rule.label.empty()) return {};
  const Box box = label_box(rule, plot, frame);
  return text((box.left + box.right) / 2, frame.at_y(rule.at) + small_size * 0.36, rule.label,
              {.size = small_size, .anchor = "middle"});
}

// A single row is a series of patches with sharp sides. Many viewers smooth what they enlarge, so each patch becomes
// several equal columns, about as many as a large print has.
ChartPicture sharpened(const ChartPicture& row) {
  constexpr int print_columns = 4000;
  const int times = row.columns > 0 ? (print_columns + row.columns - 1) / row.columns : 1;
  if (row.rows != 1 || times <= 1 || row.rgb.size() != 3 * static_cast<std::size_t>(row.columns)) return row;
  ChartPicture wide{row.x_low, row.x_high, row.y_low, row.y_high, row.columns * times, 1, {}};
  wide.rgb.reserve(row.rgb.size() * static_cast<std::size_t>(times));
  for (auto color = row.rgb.begin(); color != row.rgb.end(); color += 3)
    for (int i = 0; i < times; ++i) wide.rgb.insert(wide.rgb.end(), color, color + 3);
  return wide;
}

std::string draw_picture(const ChartPicture& shown, const Frame& frame, const std::string& id) {
  const Box box{frame.at_x(shown.x_low), frame.at_y(shown.y_high), frame.at_x(shown.x_high), frame.at_y(shown.y_low)};
  if (!(std::isfinite(box.width() + box.height()) && box.width() > 0 && box.height() > 0)) return {};
  const ChartPicture sharp = sharpened(shown);
  const std::string svg = picture(box, sharp.columns, sharp.rows, sharp.rgb);
  constexpr double slack = 0.005;  // px
  const bool inside = box.left >= frame.left - slack && box.right <= frame.right + slack &&
                      box.top >= frame.top - slack && box.bottom <= frame.bottom + slack;
  return inside || svg.empty() ? svg : clipped(frame, id, svg);
}

}  // namespace

std::string draw_plot(const ChartPlot& plot, const Frame& frame, const std::string& id) {
  std::string svg = plot.picture ? draw_picture(*plot.picture, frame, id + "-picture") : "";
  std::string lines;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    lines += draw_series(plot.series[i], i, frame, plot.picture.has_value());
  // Only limits of the caller's own cut lines off.
  const bool clip = std::any_of(plot.series.begin(), plot.series.end(), [&](const ChartSeries& series) {
    const auto outside = [](const std::vector<double>& values, Range range) {
      return std::any_of(values.begin(), values.end(), [&](double v) { return v < range.low || v > range.high; });
    };
    return outside(series.x, frame.x) || outside(series.y, frame.y);
  });
  for (const ChartRule& rule : plot.rules) svg += draw_rule(rule, plot, frame);
  svg += clip ? clipped(frame, id, lines) : "<g>\n" + lines + "</g>\n";
  svg += outline(frame);
  for (const ChartRule& rule : plot.rules) svg += draw_rule_label(rule, plot, frame);
  return svg + draw_end_labels(plot, frame);
}

double end_label_room(const ChartPlot& plot) {
  double widest = 0;
  for (const ChartSeries& series : plot.series) widest = std::max(widest, text_width(series.end_label, end_text_size));
  return widest > 0 ? widest + 2 * end_gap : 0;
}

std::string draw_strip(const ChartStrip& strip, const Frame& frame, const std::string& id) {
  ChartPicture row{strip.low, strip.high, frame.y.low, frame.y.high, static_cast<int>(strip.colors.size()), 1, {}};
  const bool mirrored = strip.low > strip.high;
  if (mirrored) std::swap(row.x_low, row.x_high);
  for (std::size_t i = 0; i < strip.colors.size(); ++i) {
    const Rgb8& color = strip.colors[mirrored ? strip.colors.size() - 1 - i : i];
    row.rgb.insert(row.rgb.end(), color.begin(), color.end());
  }
  std::string svg = draw_picture(row, frame, id) + outline(frame);
  if (!strip.side_label.empty())
    svg += text(frame.left - 8, (frame.top + frame.bottom) / 2 + small_size * 0.36, strip.side_label,
                {.size = small_size, .anchor = "end"});
  return svg;
}

std::string draw_spans(const std::vector<ChartSpan>& spans, const Frame& frame, double edge_y, bool above) {
  const double middle_y = above ? edge_y - span_line / 2 : edge_y + span_line / 2;
  std::string svg;
  for (const ChartSpan& span : spans) {
    const double left = std::max(frame.at_x(span.low), frame.left);
    const double right = std::min(frame.at_x(span.high), frame.right);
    if (!(right > left)) continue;
    for (const auto& [x, value] : {std::pair{left, span.low}, std::pair{right, span.high}})
      if (value >= frame.x.low && value <= frame.x.high) svg += line(x, middle_y - 5, x, middle_y + 5, "#333333", 1);
    const auto room_for = [](const std::string& label) { return text_width(label, end_text_size) + 2 * rule_pad; };
    const std::string& label = room_for(span.label) > right - left ? span.short_label : span.label;
    const double gap = room_for(label);
    const double middle = (left + right) / 2;
    if (gap > right - left || label.empty()) {
      svg += line(left, middle_y, right, middle_y, "#888888", 0.75);
      continue;
    }
    svg += line(left, middle_y, middle - gap / 2, middle_y, "#888888", 0.75);
    svg += line(middle + gap / 2, middle_y, right, middle_y, "#888888", 0.75);
    svg += text(middle, middle_y + end_text_size * 0.36, label, {.size = end_text_size, .anchor = "middle"});
  }
  return svg;
}

std::string draw_legend(const Chart& chart, double left, double right, double& y) {
  std::string svg;
  double x = left;
  bool any = false;
  const auto add = [&](const ChartPlot& plot) {
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
      const ChartSeries& series = plot.series[i];
      if (series.label.empty()) continue;
      const double width = legend_stroke + 6 + text_width(series.label, small_size);
      if (any && x + width > right) {
        x = left;
        y += legend_line;
      }
      svg += "<line" + attribute("x1", px(x)) + attribute("y1", px(y + 10)) + attribute("x2", px(x + legend_stroke)) +
             attribute("y2", px(y + 10)) + stroke_style(series, i) + " fill=\"none\"/>\n";
      svg += text(x + legend_stroke + 6, y + 14, series.label, {.size = small_size});
      x += width + legend_gap;
      any = true;
    }
  };
  add(chart);
  for (const ChartPlot& plot : chart.further) add(plot);
  if (any) y += legend_line + 4;
  return svg;
}

}  // namespace shabon::io::svg
