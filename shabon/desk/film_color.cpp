#include "shabon/desk/film_color.h"

namespace shabon::desk {

namespace {

// The colour as it looks under the white of `space`.
color::Xyz adapted(color::ColorSpace space, color::Xyz colour, color::Xyz white,
                   std::optional<color::Adaptation> adaptation) {
  const std::optional<color::Xyz> target = color::white_of(space);
  return adaptation && target ? color::adapt(colour, white, *target, *adaptation) : colour;
}

}  // namespace

Color color_of(const color::Spectrum& share, const color::Illuminant& lamp, const color::Observer& observer,
               const ColorOptions& options) {
  return color_of(color::reflectance_to_xyz(share, lamp, observer), color::white_point(lamp, observer), options);
}

Color color_of(color::Xyz colour, color::Xyz white, const ColorOptions& options) {
  Color result;
  result.xyz = colour;
  result.xy = color::chromaticity(colour);
  result.lab = color::xyz_to_lab(colour, white);
  result.linear_srgb = color::xyz_to_linear_srgb(adapted(color::ColorSpace::sRGB, colour, white, options.adaptation));
  result.srgb = color::encode_srgb(result.linear_srgb);
  result.srgb_mapped = color::encode_srgb(color::map_to_srgb_gamut(result.linear_srgb, options.mapping));
  result.in_gamut = color::in_srgb_gamut(result.linear_srgb, color::gamut_rounding);
  return result;
}

std::array<double, 3> in_space(color::ColorSpace space, color::Xyz colour, color::Xyz white,
                               std::optional<color::Adaptation> adaptation) {
  return color::from_xyz(space, adapted(space, colour, white, adaptation), white);
}

}  // namespace shabon::desk
