// The axes of a chart: ranges, ticks and their labels. Inside the room only.
#pragma once

#include <string>

#include "shabon/io/svg.h"
#include "shabon/io/svg_elements.h"

namespace shabon::io::svg {

inline constexpr double text_size = 13, small_size = 12;
inline constexpr double tick_length = 5;

struct Range {
  double low = 0, high = 1;
};

// The rectangle that values are drawn in.
struct Frame : Box {
  Range x, y;
  double at_x(double value) const { return left + (value - x.low) / (x.high - x.low) * width(); }
  double at_y(double value) const { return bottom - (value - y.low) / (y.high - y.low) * height(); }
};

// The ranges of all plots and strips; never empty.
Range x_range(const Chart& chart);
Range y_range(const ChartPlot& plot);

// Whether there is anything to draw in the plot.
bool is_drawn(const ChartPlot& plot);

// Vertical grid lines, over the height of the frame.
std::string x_grid(const Frame& frame);
// Ticks below `axis_y`, with their numbers where wanted.
std::string x_ticks(const Frame& frame, double axis_y, bool numbers);
// What the last of these numbers needs to the right of the frame.
double x_label_room(const Frame& frame);
std::string y_axis(const Frame& frame, const std::string& label, bool grid);

}  // namespace shabon::io::svg
