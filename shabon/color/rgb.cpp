#include "shabon/color/rgb.h"

#include <algorithm>
#include <cmath>

namespace shabon::color {

namespace {

// The transfer function of IEC 61966-2-1.
constexpr double linear_limit = 0.0031308;
constexpr double encoded_limit = 0.04045;
constexpr double slope = 12.92;
constexpr double offset = 0.055;
constexpr double exponent = 2.4;

// 0..1; written so that NaN becomes 0.
double clip(double value) { return value > 0 ? std::min(value, 1.0) : 0.0; }

}  // namespace

LinearRgb xyz_to_linear_srgb(Xyz colour) {
  const Vector3 rgb = multiply(xyz_to_srgb_matrix, Vector3{colour.x, colour.y, colour.z});
  return {rgb[0], rgb[1], rgb[2]};
}

Xyz linear_srgb_to_xyz(LinearRgb colour) {
  const Vector3 xyz = multiply(srgb_to_xyz_matrix, Vector3{colour.r, colour.g, colour.b});
  return {xyz[0], xyz[1], xyz[2]};
}

double srgb_curve(double linear) {
  if (linear <= linear_limit) return slope * linear;
  const double power = std::pow(linear, 1 / exponent);
  return power + offset * (power - 1);  // 1.055 power - 0.055, and exactly 1 for 1
}

double srgb_curve_inverse(double encoded) {
  return encoded <= encoded_limit ? encoded / slope : std::pow((encoded + offset) / (1 + offset), exponent);
}

double encode_srgb(double linear) { return srgb_curve(clip(linear)); }
double decode_srgb(double encoded) { return srgb_curve_inverse(clip(encoded)); }

EncodedRgb encode_srgb(LinearRgb colour) {
  return {encode_srgb(colour.r), encode_srgb(colour.g), encode_srgb(colour.b)};
}

LinearRgb decode_srgb(EncodedRgb colour) {
  return {decode_srgb(colour.r), decode_srgb(colour.g), decode_srgb(colour.b)};
}

std::array<std::uint8_t, 3> to_bytes(EncodedRgb colour) {
  constexpr auto byte = [](double value) { return static_cast<std::uint8_t>(std::floor(255 * clip(value) + 0.5)); };
  return {byte(colour.r), byte(colour.g), byte(colour.b)};
}

std::string to_hex(EncodedRgb colour) {
  constexpr char digits[] = "0123456789abcdef";
  std::string hex = "#";
  for (const std::uint8_t byte : to_bytes(colour)) {
    hex += digits[byte >> 4];
    hex += digits[byte & 15];
  }
  return hex;
}

}  // namespace shabon::color
