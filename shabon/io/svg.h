// Charts as SVG, fit for the screen and for print: lines, strips of colour, pictures with axes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::io {

using Rgb8 = std::array<std::uint8_t, 3>;  // encoded sRGB

struct ChartAxis {
  std::string label;                // with its unit: "wavelength (nm)"
  std::optional<double> low, high;  // limits; from the data where absent
};

struct ChartSeries {
  std::string label;  // for the legend; empty: not listed
  std::string color;  // "#rrggbb"; empty: the next of a palette that colour-blind readers can tell apart
  bool dashed = false;
  std::vector<double> x, y;    // of equal length; a value that is not finite leaves a gap
  double width_px = 2;         // of the line
  std::string end_label = {};  // written beyond the last point, along the line; left out where an earlier one is near
};

// A labelled part of the horizontal axis, such as an order of interference.
struct ChartSpan {
  double low = 0, high = 1;
  std::string label, short_label = {};  // the first of them that is not wider than the part
};

// A dashed line across a plot.
struct ChartRule {
  double at = 0;  // on the vertical axis
  std::string label;
};

// Equal patches of colour from `low` to `high` on the horizontal axis, drawn above the lines.
struct ChartStrip {
  std::string label;       // above it
  std::string side_label;  // left of it, short
  double low = 0, high = 1;
  std::vector<Rgb8> colors;
  std::vector<ChartSpan> spans;  // marked along its upper edge
};

// A picture that fills x_low..x_high, y_low..y_high of a plot.
struct ChartPicture {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> rgb;  // 3 columns rows values, encoded sRGB, the first row on top (y_high)
};

// Lines, and below them a picture, with a vertical axis.
struct ChartPlot {
  std::string heading;  // above it, for charts of several plots
  ChartAxis y;
  std::vector<ChartSeries> series;
  std::optional<ChartPicture> picture;
  std::vector<ChartRule> rules;
  std::string end_title;  // what the lines' end labels are
};

// A chart is its main plot with strips above it and, where wanted, further plots below it, over one horizontal axis.
// A plot without series, picture and rules is not drawn. Without any plot the strips share the height.
struct Chart : ChartPlot {
  std::string title, subtitle;
  std::vector<std::string> notes;  // lines at the foot
  ChartAxis x;
  std::vector<ChartStrip> strips;
  std::vector<ChartPlot> further;
  std::vector<ChartSpan> spans;  // marked below the horizontal axis
  int strip_height_px = 26;      // where there is a plot, too
  // Of the whole drawing; 96 px are an inch. The text is 9 to 13 points. Height 0: as much as the contents need, with
  // strips of strip_height_px.
  int width_px = 800, height_px = 500;
};

// A complete SVG 1.1 document. Any chart is drawn, also an empty one.
std::string chart_svg(const Chart& chart);

// Round values (1, 2 or 5 times a power of ten apart), about `count` of them, inside [low, high]. Empty unless
// low < high, both finite.
std::vector<double> nice_ticks(double low, double high, int count);

// "#rrggbb" for the line `index` of `count` lines in a natural order, such as rising angles: dark violet to green, told
// apart by lightness alone too.
std::string sequence_color(std::size_t index, std::size_t count);

}  // namespace shabon::io
