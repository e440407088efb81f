#include "shabon/desk/film_color.h"

#include "shabon/color/gamut.h"

namespace shabon::desk {

Color color_of(const color::Spectrum& share, const color::Illuminant& lamp, const color::Observer& observer) {
  Color result;
  result.xyz = color::reflectance_to_xyz(share, lamp, observer);
  result.xy = color::chromaticity(result.xyz);
  result.lab = color::xyz_to_lab(result.xyz, color::white_point(lamp, observer));
  result.linear_srgb = color::xyz_to_linear_srgb(result.xyz);
  result.srgb = color::encode_srgb(result.linear_srgb);
  result.srgb_mapped =
      color::encode_srgb(color::map_to_srgb_gamut(result.linear_srgb, color::GamutMapping::reduce_chroma));
  result.in_gamut = color::in_srgb_gamut(result.linear_srgb);
  return result;
}

}  // namespace shabon::desk
