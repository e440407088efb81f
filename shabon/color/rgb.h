// sRGB (IEC 61966-2-1): linear by equation (18), encoded by (19).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "shabon/color/matrix3.h"
#include "shabon/color/xyz.h"

namespace shabon::color {

// Light, proportional to power. Unclipped: a film colour outside sRGB has a negative component.
struct LinearRgb {
  double r = 0, g = 0, b = 0;
  constexpr bool operator==(const LinearRgb&) const = default;
};

// What a picture file holds, 0..1.
struct EncodedRgb {
  double r = 0, g = 0, b = 0;
  constexpr bool operator==(const EncodedRgb&) const = default;
};

// Chromaticities of the sRGB primaries and of its white, as the standard states them.
inline constexpr Xy srgb_red{0.64, 0.33}, srgb_green{0.30, 0.60}, srgb_blue{0.15, 0.06}, srgb_white{0.3127, 0.3290};

// The matrix whose columns are the XYZ of the primaries, scaled so that (1, 1, 1) is the white with Y = 1.
constexpr Matrix3 rgb_to_xyz_from(Xy red, Xy green, Xy blue, Xy white) {
  constexpr auto direction = [](Xy c) { return Vector3{c.x / c.y, 1, (1 - c.x - c.y) / c.y}; };
  const Vector3 r = direction(red), g = direction(green), b = direction(blue);
  Matrix3 matrix{Vector3{r[0], g[0], b[0]}, Vector3{r[1], g[1], b[1]}, Vector3{r[2], g[2], b[2]}};
  const Vector3 luminance = multiply(inverse(matrix), direction(white));
  for (Vector3& row : matrix)
    for (std::size_t j = 0; j < 3; ++j) row[j] *= luminance[j];
  return matrix;
}

// In full precision, not the standard's four decimals.
inline constexpr Matrix3 srgb_to_xyz_matrix = rgb_to_xyz_from(srgb_red, srgb_green, srgb_blue, srgb_white);
inline constexpr Matrix3 xyz_to_srgb_matrix = inverse(srgb_to_xyz_matrix);

LinearRgb xyz_to_linear_srgb(Xyz colour);
Xyz linear_srgb_to_xyz(LinearRgb colour);

// The curve of (19) for values >= 0, without clipping, and its inverse.
double srgb_curve(double linear);
double srgb_curve_inverse(double encoded);

// One component. Clips to 0..1 first; NaN becomes 0.
double encode_srgb(double linear);
double decode_srgb(double encoded);

EncodedRgb encode_srgb(LinearRgb colour);
LinearRgb decode_srgb(EncodedRgb colour);

// 8 bits a component, floor(255 v + 0.5).
std::array<std::uint8_t, 3> to_bytes(EncodedRgb colour);

// "#rrggbb" of the same bytes, in lower case.
std::string to_hex(EncodedRgb colour);

}  // namespace shabon::color
