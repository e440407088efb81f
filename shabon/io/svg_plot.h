// The contents of a chart: lines, pictures, strips of colour, marked parts of the axis. Inside the room only.
#pragma once

#include <string>

#include "shabon/io/svg.h"
#include "shabon/io/svg_axes.h"

namespace shabon::io::svg {

inline constexpr double span_line = 18;  // the height that marked parts take
inline constexpr double end_text_size = 11;

// The picture, the lines and the rules inside the frame, its outline, and the end labels beyond it. `id` is the plot's
// own among those of the drawing.
std::string draw_plot(const ChartPlot& plot, const Frame& frame, const std::string& id);

// The room that the end labels need above the frame and right of it.
double end_label_room(const ChartPlot& plot);

// The strip in the frame, its side label and the outline.
std::string draw_strip(const ChartStrip& strip, const Frame& frame, const std::string& id);

// The parts in the span_line above or below `edge_y`.
std::string draw_spans(const std::vector<ChartSpan>& spans, const Frame& frame, double edge_y, bool above);

// Entries from left to right, wrapping; moves `y` below them.
std::string draw_legend(const Chart& chart, double left, double right, double& y);

}  // namespace shabon::io::svg
