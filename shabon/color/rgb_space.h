// RGB spaces: primaries, white and transfer function, and the matrices that follow from them.
#pragma once

#include "shabon/color/matrix3.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

struct RgbSpace {
  Xy red, green, blue, white;      // chromaticities, CIE 1931
  double (*encode)(double light);  // null where the space is linear
  double (*decode)(double value);

  constexpr Matrix3 to_xyz() const { return rgb_to_xyz_from(red, green, blue, white); }
  constexpr Matrix3 from_xyz() const { return inverse(to_xyz()); }
};

// Transfer functions as they are used beyond 0..1: mirrored at 0, and continued above 1. No clipping.
double encode_srgb_unclipped(double light);
double decode_srgb_unclipped(double value);
double encode_bt2020(double light);
double decode_bt2020(double value);

// IEC 61966-2-1.
inline constexpr RgbSpace srgb_space{
    srgb_red, srgb_green, srgb_blue, srgb_white, encode_srgb_unclipped, decode_srgb_unclipped};

// Display P3: the primaries of SMPTE RP 431-2, D65 and the transfer function of sRGB (SMPTE EG 432-1; Apple 2015).
inline constexpr RgbSpace display_p3_space{{0.680, 0.320}, {0.265, 0.690},        {0.150, 0.060},
                                           srgb_white,     encode_srgb_unclipped, decode_srgb_unclipped};

// ITU-R BT.2020-2, table 3 (primaries and white) and table 4 (transfer function of the camera).
inline constexpr RgbSpace rec2020_space{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046},
                                        srgb_white,     encode_bt2020,  decode_bt2020};

// ACEScg, Academy S-2014-004: primaries AP1 and the white of ACES, near D60. Linear.
inline constexpr RgbSpace acescg_space{{0.713, 0.293},     {0.165, 0.830}, {0.128, 0.044},
                                       {0.32168, 0.33767}, nullptr,        nullptr};

}  // namespace shabon::color
