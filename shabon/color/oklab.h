// Oklab: B. Ottosson, "A perceptual color space for image processing" (2020), https://bottosson.github.io/posts/oklab.
#pragma once

#include "shabon/color/matrix3.h"
#include "shabon/color/rgb.h"

namespace shabon::color {

struct Oklab {
  double L = 0, a = 0, b = 0;  // L is 1 for the white of sRGB
  constexpr bool operator==(const Oklab&) const = default;
};

// Linear sRGB to the cone responses l, m, s. Each row sums to 1.
inline constexpr Matrix3 srgb_to_cones{Vector3{0.4122214708, 0.5363325363, 0.0514459929},
                                       Vector3{0.2119034982, 0.6806995451, 0.1073969566},
                                       Vector3{0.0883024619, 0.2817188376, 0.6299787005}};
inline constexpr Matrix3 cones_to_srgb = inverse(srgb_to_cones);

// The cube roots of the cone responses to L, a, b.
inline constexpr Matrix3 cone_roots_to_oklab{Vector3{0.2104542553, 0.7936177850, -0.0040720468},
                                             Vector3{1.9779984951, -2.4285922050, 0.4505937099},
                                             Vector3{0.0259040371, 0.7827717662, -0.8086757660}};

// Any colour, also outside sRGB: roots keep the sign.
Oklab linear_srgb_to_oklab(LinearRgb colour);
LinearRgb oklab_to_linear_srgb(Oklab colour);

}  // namespace shabon::color
