// Line charts and strips of colour as SVG, fit for the screen and for print.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::io {

struct ChartAxis {
  std::string label;                // with its unit: "wavelength (nm)"
  std::optional<double> low, high;  // limits; from the data where absent
};

struct ChartSeries {
  std::string label;  // for the legend; empty: not listed
  std::string color;  // "#rrggbb"; empty: the next of a palette that colour-blind readers can tell apart
  bool dashed = false;
  std::vector<double> x, y;  // of equal length; a value that is not finite leaves a gap
};

// Equal patches of colour from `low` to `high` on the horizontal axis, drawn below the lines.
struct ChartStrip {
  std::string label;
  double low = 0, high = 1;
  std::vector<std::string> colors;  // "#rrggbb"
};

struct Chart {
  std::string title, subtitle;
  ChartAxis x, y;
  std::vector<ChartSeries> series;  // without any, only the strips and the horizontal axis are drawn
  std::vector<ChartStrip> strips;
  int width_px = 800, height_px = 500;  // of the whole drawing
};

// A complete SVG 1.1 document. Any chart is drawn, also an empty one.
std::string chart_svg(const Chart& chart);

// Round values (1, 2 or 5 times a power of ten apart), about `count` of them, inside [low, high]. Empty unless
// low < high, both finite.
std::vector<double> nice_ticks(double low, double high, int count);

}  // namespace shabon::io
