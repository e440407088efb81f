// Film colours outside sRGB, and what to show instead: equation (20).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "shabon/color/rgb.h"

namespace shabon::color {

enum class GamutMapping {
  clip,           // each component to 0..1; simple, but changes hue and lightness
  reduce_chroma,  // lightness and, nearly, hue stay; chroma shrinks to the boundary of sRGB
};

struct GamutMappingEntry {
  GamutMapping mapping;
  std::string_view name, description;
};

// All of them.
std::span<const GamutMappingEntry> gamut_mappings();

// By name, ignoring case.
std::optional<GamutMapping> find_gamut_mapping(std::string_view name);
std::string_view name_of(GamutMapping mapping);

// Whether every component lies in 0 - tolerance .. 1 + tolerance. NaN does not.
bool in_srgb_gamut(LinearRgb colour, double tolerance = 0);

// The colour of the sRGB cube, 0..1, that stands for `colour`. Colours inside come back unchanged to the last bit, so
// mapping twice is mapping once. Continuous; brighter than white is white; NaN counts as 0.
LinearRgb map_to_srgb_gamut(LinearRgb colour, GamutMapping mapping);

}  // namespace shabon::color
