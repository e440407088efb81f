// The colours of a film for people.
#include <fmt/format.h>

#include "color_report.h"
#include "shabon/base/text.h"
#include "swatch.h"

namespace shabon::app {

namespace {

std::string row(std::string_view label, double a, double b, double c) {
  return fmt::format("{:<14}{:>11.6f} {:>11.6f} {:>11.6f}\n", label, a, b, c);
}

std::string row(std::string_view label, color::EncodedRgb colour) {
  const std::string patch = swatch_wanted() ? swatch(colour) : "";
  return fmt::format("{:<14}{:>11.6f} {:>11.6f} {:>11.6f}  {}{}\n", label, colour.r, colour.g, colour.b,
                     color::to_hex(colour), patch);
}

std::string rows(const ColorReport& report, const FilmColor& film) {
  const desk::Color& c = film.color;
  std::string text = row("XYZ", c.xyz.x, c.xyz.y, c.xyz.z);
  text += fmt::format("{:<14}{:>11.6f} {:>11.6f}\n", "xy", c.xy.x, c.xy.y);
  text += row("Lab", c.lab.L, c.lab.a, c.lab.b);
  for (std::size_t i = 0; i < report.spaces.size(); ++i) {
    const std::array<double, 3>& values = film.in_spaces[i];
    text += row(color::name_of(report.spaces[i]), values[0], values[1], values[2]);
  }
  text += row("linear sRGB", c.linear_srgb.r, c.linear_srgb.g, c.linear_srgb.b);
  text += row("sRGB clipped", c.srgb);
  text += row("sRGB mapped", c.srgb_mapped);
  return text + (c.in_gamut ? "inside sRGB\n" : "outside sRGB\n");
}

}  // namespace

std::string color_text(const ColorReport& report) {
  std::string text = printable(report.expression) + "\n";
  text +=
      fmt::format("unpolarised, {}, lamp {}, observer {}{}\n", optics::name_of(report.interference),
                  printable(report.lamp, 60), report.observer, report.reversed ? ", light from the other side" : "");
  if (report.options.adaptation)
    text += fmt::format("RGB adapted from the lamp's white by {}\n", color::name_of(*report.options.adaptation));
  for (const FilmColor& film : report.colors) {
    text += fmt::format("\n{} at {} degrees\n", film.side == desk::Side::reflected ? "reflected" : "transmitted",
                        format_number(film.incidence_deg));
    text += rows(report, film);
  }
  return text;
}

}  // namespace shabon::app
