// A colour of a surface as a scene file states it: a reflectance in one of four spellings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "shabon/color/rgb.h"
#include "shabon/math/vec.h"

namespace shabon::scene {

// A number 0..1: the same at all wavelengths. Three numbers 0..1: linear sRGB. A text: "#rrggbb", encoded sRGB, or
// "file:PATH", a table of the reflectance over the wavelength, relative to the scene file.
struct ColorDesc {
  std::variant<double, math::Vec3d, std::string> value = 0.5;
  friend bool operator==(const ColorDesc&, const ColorDesc&) = default;
};

// Linear sRGB of "#rrggbb"; nothing when the text is not written so.
std::optional<color::LinearRgb> hex_color(std::string_view text);

// The path in "file:PATH", or nothing.
std::optional<std::string> color_file(std::string_view text);

}  // namespace shabon::scene
