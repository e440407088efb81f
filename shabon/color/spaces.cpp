#include "shabon/color/spaces.h"

#include <cmath>
#include <numbers>

#include "shabon/base/text.h"
#include "shabon/color/lab.h"
#include "shabon/color/oklab.h"
#include "shabon/color/rgb_space.h"

namespace shabon::color {

namespace {

constexpr ColorSpaceEntry entries[] = {
    {ColorSpace::XYZ, "XYZ", "CIE tristimulus values, Y = 1 for the perfect reflector", {"X", "Y", "Z"}},
    {ColorSpace::xyY, "xyY", "CIE chromaticity and luminance", {"x", "y", "Y"}},
    {ColorSpace::Lab, "Lab", "CIE 1976 L*a*b* under the lamp", {"L", "a", "b"}},
    {ColorSpace::LCh, "LCh", "CIE 1976 lightness, chroma and hue (degrees) under the lamp", {"L", "C", "h"}},
    {ColorSpace::Oklab, "Oklab", "Oklab (Ottosson 2020), white D65", {"L", "a", "b"}},
    {ColorSpace::sRGB, "sRGB", "sRGB, IEC 61966-2-1", {"r", "g", "b"}},
    {ColorSpace::DisplayP3, "Display P3", "P3 primaries, white D65, transfer function of sRGB", {"r", "g", "b"}},
    {ColorSpace::Rec2020, "Rec.2020", "ITU-R BT.2020", {"r", "g", "b"}},
    {ColorSpace::ACEScg, "ACEScg", "ACES AP1 primaries, linear, Academy S-2014-004", {"r", "g", "b"}},
};

constexpr double degree = std::numbers::pi / 180;

const RgbSpace* rgb_of(ColorSpace space) {
  switch (space) {
    case ColorSpace::sRGB:
      return &srgb_space;
    case ColorSpace::DisplayP3:
      return &display_p3_space;
    case ColorSpace::Rec2020:
      return &rec2020_space;
    case ColorSpace::ACEScg:
      return &acescg_space;
    default:
      return nullptr;
  }
}

struct RgbMatrices {
  Matrix3 to_xyz, from_xyz;
};

template <const RgbSpace& space>
constexpr RgbMatrices matrices{space.to_xyz(), space.from_xyz()};

const RgbMatrices& matrices_of(ColorSpace space) {
  switch (space) {
    case ColorSpace::DisplayP3:
      return matrices<display_p3_space>;
    case ColorSpace::Rec2020:
      return matrices<rec2020_space>;
    case ColorSpace::ACEScg:
      return matrices<acescg_space>;
    default:
      return matrices<srgb_space>;
  }
}

Vector3 vector_of(Xyz c) { return {c.x, c.y, c.z}; }
Xyz xyz_of(const Vector3& v) { return {v[0], v[1], v[2]}; }

Vector3 xyy_from(Xyz colour, Xyz white) {
  const bool black = colour.x == 0 && colour.y == 0 && colour.z == 0;
  const Xyz shown = black ? white : colour;
  const double sum = shown.x + shown.y + shown.z;
  return {shown.x / sum, shown.y / sum, colour.y};
}

Xyz xyz_from_xyy(const Vector3& c) {
  if (c[2] == 0) return {};
  return {c[0] * c[2] / c[1], c[2], (1 - c[0] - c[1]) * c[2] / c[1]};
}

Vector3 lch_from(Lab lab) {
  const double hue = std::atan2(lab.b, lab.a) / degree;
  return {lab.L, std::hypot(lab.a, lab.b), lab.a == 0 && lab.b == 0 ? 0 : hue < 0 ? hue + 360 : hue};
}

}  // namespace

std::span<const ColorSpaceEntry> color_spaces() { return entries; }

std::optional<ColorSpace> find_color_space(std::string_view name) {
  const auto without_blanks = [](std::string_view text) {
    std::string result;
    for (const char c : text)
      if (c != ' ') result += c;
    return result;
  };
  for (const ColorSpaceEntry& entry : entries)
    if (same_name(without_blanks(entry.name), without_blanks(name))) return entry.space;
  return {};
}

std::string_view name_of(ColorSpace space) {
  for (const ColorSpaceEntry& entry : entries)
    if (entry.space == space) return entry.name;
  return {};
}

std::array<double, 3> from_xyz(ColorSpace space, Xyz colour, Xyz white) {
  switch (space) {
    case ColorSpace::XYZ:
      return vector_of(colour);
    case ColorSpace::xyY:
      return xyy_from(colour, white);
    case ColorSpace::Lab: {
      const Lab lab = xyz_to_lab(colour, white);
      return {lab.L, lab.a, lab.b};
    }
    case ColorSpace::LCh:
      return lch_from(xyz_to_lab(colour, white));
    case ColorSpace::Oklab: {
      const Oklab lab = linear_srgb_to_oklab(xyz_to_linear_srgb(colour));
      return {lab.L, lab.a, lab.b};
    }
    default:
      return multiply(matrices_of(space).from_xyz, vector_of(colour));
  }
}

Xyz to_xyz(ColorSpace space, const std::array<double, 3>& c, Xyz white) {
  switch (space) {
    case ColorSpace::XYZ:
      return xyz_of(c);
    case ColorSpace::xyY:
      return xyz_from_xyy(c);
    case ColorSpace::Lab:
      return lab_to_xyz({c[0], c[1], c[2]}, white);
    case ColorSpace::LCh:
      return lab_to_xyz({c[0], c[1] * std::cos(c[2] * degree), c[1] * std::sin(c[2] * degree)}, white);
    case ColorSpace::Oklab:
      return linear_srgb_to_xyz(oklab_to_linear_srgb({c[0], c[1], c[2]}));
    default:
      return xyz_of(multiply(matrices_of(space).to_xyz, c));
  }
}

std::optional<Xyz> white_of(ColorSpace space) {
  const RgbSpace* rgb = space == ColorSpace::Oklab ? &srgb_space : rgb_of(space);
  if (rgb == nullptr) return {};
  return xyz_from_xyy({rgb->white.x, rgb->white.y, 1});
}

bool is_encoded(ColorSpace space) {
  const RgbSpace* rgb = rgb_of(space);
  return rgb != nullptr && rgb->encode != nullptr;
}

std::array<double, 3> encoded(ColorSpace space, const std::array<double, 3>& linear) {
  if (!is_encoded(space)) return linear;
  const auto f = rgb_of(space)->encode;
  return {f(linear[0]), f(linear[1]), f(linear[2])};
}

std::array<double, 3> decoded(ColorSpace space, const std::array<double, 3>& values) {
  if (!is_encoded(space)) return values;
  const auto f = rgb_of(space)->decode;
  return {f(values[0]), f(values[1]), f(values[2])};
}

}  // namespace shabon::color
