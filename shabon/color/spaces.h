// The colour spaces one can ask for, each in one line of a list, equation (43).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "shabon/color/xyz.h"

namespace shabon::color {

enum class ColorSpace { XYZ, xyY, Lab, LCh, Oklab, sRGB, DisplayP3, Rec2020, ACEScg };

struct ColorSpaceEntry {
  ColorSpace space;
  std::string_view name, description;
  std::array<std::string_view, 3> components;
};

// All of them.
std::span<const ColorSpaceEntry> color_spaces();

// By name, ignoring case and blanks ("Display P3", "displayp3").
std::optional<ColorSpace> find_color_space(std::string_view name);
std::string_view name_of(ColorSpace space);

// The three components of a colour, and back. RGB is linear light, unclipped; Lab and LCh take `white` (positive, with
// Y = 1 as white_point() gives it), the others ignore it. Hue in degrees, 0..360, 0 for a grey; black has the
// chromaticity of `white` in xyY. There is no chromatic adaptation: whoever wants the lamp to be the white of an RGB
// space adapts first (adaptation.h) to white_of() it.
std::array<double, 3> from_xyz(ColorSpace space, Xyz colour, Xyz white);
Xyz to_xyz(ColorSpace space, const std::array<double, 3>& components, Xyz white);

// The white of the space, with Y = 1: of sRGB, Display P3, Rec.2020 and Oklab (0.3127, 0.3290), of ACEScg
// (0.32168, 0.33767). The others have none of their own.
std::optional<Xyz> white_of(ColorSpace space);

// Whether the space has a transfer function: sRGB and Display P3 (19), Rec.2020.
bool is_encoded(ColorSpace space);

// Each component by the transfer function of the space, mirrored at 0 and continued above 1, so that nothing is lost;
// unchanged where there is none.
std::array<double, 3> encoded(ColorSpace space, const std::array<double, 3>& linear);
std::array<double, 3> decoded(ColorSpace space, const std::array<double, 3>& values);

}  // namespace shabon::color
