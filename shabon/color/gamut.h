// Film colours outside sRGB, and what to show instead: equation (20).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "shabon/color/rgb.h"

namespace shabon::color {

enum class GamutMapping {
  clip,           // each component to 0..1; simple, but changes hue and lightness
  reduce_chroma,  // lightness stays; chroma shrinks to the boundary of sRGB, to nothing for a colour as light as white
  keep_hue,       // towards a grey between the colour's lightness and that of the hue's strongest colour
  gentle,         // the same lines; what is near the boundary makes room for what is beyond it
};

// What the desk and the renderer use unless another one is asked for.
inline constexpr GamutMapping default_gamut_mapping = GamutMapping::keep_hue;

struct GamutMappingEntry {
  GamutMapping mapping;
  std::string_view name, description;
  bool keeps_inside;  // colours of the sRGB cube come back unchanged to the last bit
};

// All of them.
std::span<const GamutMappingEntry> gamut_mappings();

// By name, ignoring case.
std::optional<GamutMapping> find_gamut_mapping(std::string_view name);
std::string_view name_of(GamutMapping mapping);

// The roundings of a colour's sums: white under D65 is not outside for the last bits of its red.
inline constexpr double gamut_rounding = 1e-9;

// Whether every component lies in 0 - tolerance .. 1 + tolerance. NaN does not.
bool in_srgb_gamut(LinearRgb colour, double tolerance = 0);

// The colour of the sRGB cube, 0..1, that stands for `colour`. Colours inside come back unchanged, so that mapping
// twice is mapping once; `gentle` keeps only those within 4/5 of the way from its grey to the boundary. Continuous; a
// grey brighter than white is white; NaN counts as 0.
LinearRgb map_to_srgb_gamut(LinearRgb colour, GamutMapping mapping = default_gamut_mapping);

}  // namespace shabon::color
