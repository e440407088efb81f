#include "chart_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"

namespace shabon::app {

namespace {

double largest_Y(std::span<const color::Xyz> colors) {
  double largest = 0;
  for (const color::Xyz& colour : colors) largest = std::max(largest, std::isfinite(colour.y) ? colour.y : 0);
  return largest;
}

// Below this a row is black but for rounding, and stays so.
constexpr double least_Y = 1e-12;

double factor_for(double largest) { return largest > least_Y ? 1 / largest : 1; }

std::string adaptation_text(const ChartOptions& options) {
  return options.adaptation ? fmt::format("adapted to the lamp ({})", color::name_of(*options.adaptation))
                            : "not adapted to the lamp";
}

}  // namespace

std::vector<double> display_factors(std::span<const std::vector<color::Xyz>> rows, const ChartOptions& options) {
  if (options.exposure == ChartExposure::stops) return std::vector<double>(rows.size(), std::exp2(options.exposure_ev));
  std::vector<double> largest;
  for (const std::vector<color::Xyz>& row : rows) largest.push_back(largest_Y(row));
  if (options.exposure == ChartExposure::one && !largest.empty())
    std::fill(largest.begin(), largest.end(), *std::max_element(largest.begin(), largest.end()));
  std::vector<double> factors;
  for (const double Y : largest) factors.push_back(factor_for(Y));
  return factors;
}

Display display_of(const ChartOptions& options) {
  Display display{color::xyz_to_srgb_matrix, options.gamut()};
  if (options.adaptation) {
    const color::Xyz lamp = color::white_point(options.lamp, options.observer());
    const color::Xyz white = color::linear_srgb_to_xyz({1, 1, 1});
    display.xyz_to_linear_srgb =
        color::multiply(color::xyz_to_srgb_matrix, color::adaptation_matrix(lamp, white, *options.adaptation));
  }
  return display;
}

color::EncodedRgb shown_color(color::Xyz colour, double factor, const Display& display) {
  const auto rgb = color::multiply(display.xyz_to_linear_srgb,
                                   color::Vector3{colour.x * factor, colour.y * factor, colour.z * factor});
  return color::encode_srgb(color::map_to_srgb_gamut({rgb[0], rgb[1], rgb[2]}, display.gamut));
}

io::Rgb8 shown_bytes(color::Xyz colour, double factor, const Display& display) {
  return color::to_bytes(shown_color(colour, factor, display));
}

std::string factor_text(double factor) {
  constexpr double noticeable = 0.02;
  if (std::abs(factor - 1) < noticeable) return {};
  return "\u00D7 " + format_number(factor, factor < 1 ? 2 : 3);
}

std::string color_cells(color::Xyz colour, double factor, const Display& display) {
  const color::LinearRgb linear = color::xyz_to_linear_srgb(colour);
  std::string cells;
  for (const double value : {colour.x, colour.y, colour.z, linear.r, linear.g, linear.b})
    cells += format_exact(value) + ",";
  return cells + format_number(factor) + "," + color::to_hex(shown_color(colour, factor, display));
}

std::string color_comments(const ChartOptions& options, std::string_view sums) {
  return fmt::format(
      "# {}\n"
      "# X, Y, Z: the lamp itself has Y = 1; {}; no chromatic adaptation\n"
      "# linear_r, linear_g, linear_b: linear sRGB, unclipped\n"
      "# hex: sRGB as drawn, after display_factor, {} and gamut mapping '{}'\n",
      light_text(options), sums, adaptation_text(options), color::name_of(options.gamut()));
}

std::string light_text(const ChartOptions& options) {
  return fmt::format("lamp {}, CIE {} observer", printable(options.lamp.name, 60), options.observer().name);
}

std::string display_note(const ChartOptions& options) {
  return fmt::format("Shown in sRGB, {}; colours beyond sRGB by gamut mapping '{}'.", adaptation_text(options),
                     color::name_of(options.gamut()));
}

}  // namespace shabon::app
