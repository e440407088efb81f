// The colours that `shabon color` prints, and their forms.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "shabon/desk/film_color.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/interference.h"

namespace shabon::app {

struct FilmColor {
  double incidence_deg = 0;
  desk::Side side = desk::Side::reflected;
  desk::Color color;
  std::vector<std::array<double, 3>> in_spaces;  // as ColorReport::spaces
};

struct ColorReport {
  std::string expression;
  optics::Interference interference = optics::Interference::airy;
  bool reversed = false;  // the light comes from the other side of the stack
  std::string lamp;
  std::string_view observer;
  desk::ColorOptions options;
  std::vector<color::ColorSpace> spaces;  // besides those that are always told
  std::vector<FilmColor> colors;          // at least one
};

// For people, with a swatch where the output is a terminal.
std::string color_text(const ColorReport& report);
// One colour is an object with the keys XYZ, xy, Lab, linear_srgb, srgb, hex, srgb_mapped, hex_mapped, in_gamut, and
// `spaces` where asked for. Several are a list of such objects, `colors`, each with angle_deg and side.
std::string color_json(const ColorReport& report);
std::string color_csv(const ColorReport& report);
// A card with a patch for each colour.
std::string color_svg(const ColorReport& report);

}  // namespace shabon::app
