// RGB primaries of pictures. Inside the room only.
#pragma once

#include <array>
#include <optional>

namespace shabon::io {

using Matrix3 = std::array<std::array<double, 3>, 3>;

struct Chromaticity {
  double x = 0, y = 0;
};

struct RgbPrimaries {
  Chromaticity red, green, blue, white;
};

// IEC 61966-2-1 (and ITU-R BT.709): sRGB's primaries and D65 white.
inline constexpr RgbPrimaries srgb_primaries{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

// From linear RGB of these primaries to XYZ, white having Y = 1 (SMPTE RP 177). Nothing when they span no colours.
std::optional<Matrix3> rgb_to_xyz(const RgbPrimaries& primaries);

// From linear RGB of these primaries to linear sRGB; XYZ stays, the white is not adapted. Nothing as above.
std::optional<Matrix3> rgb_to_srgb(const RgbPrimaries& primaries);

// Whether a matrix changes nothing that matters: every element within 1e-5 of the identity's.
bool is_identity(const Matrix3& matrix);

}  // namespace shabon::io
