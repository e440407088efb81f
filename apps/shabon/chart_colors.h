// Colours as a chart shows them, in sRGB, and as its table lists them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "chart.h"
#include "shabon/color/matrix3.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"

namespace shabon::app {

// The factors that brighten the rows of a chart, such as its angles: ChartExposure::each brings the largest Y of every
// row to 1, `one` that of all rows, `stops` is the same 2^EV everywhere. A black row gets 1.
std::vector<double> display_factors(std::span<const std::vector<color::Xyz>> rows, const ChartOptions& options);

// How colours become what is drawn.
struct Display {
  color::Matrix3 xyz_to_linear_srgb;  // with the adaptation to the lamp, where it is asked for
  color::GamutMapping gamut;
};

Display display_of(const ChartOptions& options);

// What is drawn for a colour: times the factor, mapped into sRGB, encoded.
color::EncodedRgb shown_color(color::Xyz colour, double factor, const Display& display);
io::Rgb8 shown_bytes(color::Xyz colour, double factor, const Display& display);

// "x 12.6", or "" when the factor changes nothing to speak of.
std::string factor_text(double factor);

// The columns of a colour in a chart's table, and its cells: XYZ and linear sRGB as they are, then what is drawn.
inline constexpr std::string_view color_columns = "X,Y,Z,linear_r,linear_g,linear_b,display_factor,hex";
std::string color_cells(color::Xyz colour, double factor, const Display& display);

// How X, Y and Z are summed up (17): of a film, and of anything else.
inline constexpr std::string_view film_sums =
    "sums over 360..830 nm at 1 nm, of means over each nanometre where a film passes more than a quarter of a fringe "
    "in it";
inline constexpr std::string_view plain_sums = "plain sums over 360..830 nm at 1 nm";

// Lines of a table's head: what the columns of colours hold, and how they are summed up.
std::string color_comments(const ChartOptions& options, std::string_view sums);

// "lamp D65, CIE 1931 observer", for titles.
std::string light_text(const ChartOptions& options);
// How colours became sRGB, for the foot of a chart.
std::string display_note(const ChartOptions& options);

}  // namespace shabon::app
