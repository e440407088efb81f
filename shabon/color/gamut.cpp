#include "shabon/color/gamut.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"

namespace shabon::color {

namespace {

// Linear sRGB to the cone responses of Oklab, and the weights of its lightness: B. Ottosson, "A perceptual color space
// for image processing" (2020), https://bottosson.github.io/posts/oklab. Each row, and the weights, sum to 1.
constexpr Matrix3 rgb_to_cones{Vector3{0.4122214708, 0.5363325363, 0.0514459929},
                               Vector3{0.2119034982, 0.6806995451, 0.1073969566},
                               Vector3{0.0883024619, 0.2817188376, 0.6299787005}};
constexpr Matrix3 cones_to_rgb = inverse(rgb_to_cones);
constexpr double weight_l = 0.2104542553, weight_m = 0.7936177850, weight_s = -0.0040720468;
constexpr double weight_sum = weight_l + weight_m + weight_s;

// Beyond any exposure; keeps infinity out of the arithmetic.
constexpr double far_outside = 1e9;

constexpr GamutMappingEntry entries[] = {
    {GamutMapping::clip, "clip", "each component is clipped to 0..1"},
    {GamutMapping::reduce_chroma, "reduce-chroma",
     "lightness and, nearly, hue stay; chroma shrinks to the boundary of sRGB"},
};

Vector3 finite(LinearRgb colour) {
  constexpr auto bounded = [](double v) { return std::isnan(v) ? 0.0 : std::clamp(v, -far_outside, far_outside); };
  return {bounded(colour.r), bounded(colour.g), bounded(colour.b)};
}

LinearRgb clip(const Vector3& rgb) {
  return {std::clamp(rgb[0], 0.0, 1.0), std::clamp(rgb[1], 0.0, 1.0), std::clamp(rgb[2], 0.0, 1.0)};
}

// The first t in 0..1 at which inside + 2 half_slope t + curvature t^2 falls to 0, starting from inside > 0; else 1.
double first_exit(double inside, double half_slope, double curvature) {
  const double discriminant = half_slope * half_slope - curvature * inside;
  if (discriminant < 0) return 1;
  const double divisor = std::sqrt(discriminant) - half_slope;
  return divisor > inside ? inside / divisor : 1;
}

// Equation (20): in the square roots of the cone responses, the straight line from the grey of the same lightness to
// the colour, as far as it stays in the cube. Square roots and not Oklab's cube roots: with those the cube hides a
// sliver of itself behind its blue corner from the greys, and no mapping along such lines can be continuous there. The
// hue of film colours stays within 2.5 degrees of Oklab's (along straight lines in linear light it would be 7.4).
LinearRgb reduce_chroma(const Vector3& rgb) {
  Vector3 roots = multiply(rgb_to_cones, rgb);
  for (double& v : roots) v = std::copysign(std::sqrt(std::abs(v)), v);
  const double lightness = (weight_l * roots[0] + weight_m * roots[1] + weight_s * roots[2]) / weight_sum;
  if (lightness <= 0) return {0, 0, 0};
  if (lightness >= 1) return {1, 1, 1};

  // Component k at t is grey + 2 slope[k] t + curve[k] t^2. The cone responses cannot change sign inside the cube, so
  // the squares hold up to the exit.
  Vector3 away, away_squared;
  for (std::size_t i = 0; i < 3; ++i) {
    away[i] = roots[i] - lightness;
    away_squared[i] = away[i] * away[i];
  }
  const double grey = lightness * lightness;
  const Vector3 along = multiply(cones_to_rgb, away), curve = multiply(cones_to_rgb, away_squared);
  double t = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = lightness * along[k];
    t = std::min({t, first_exit(grey, slope, curve[k]), first_exit(1 - grey, -slope, -curve[k])});
  }
  Vector3 mapped;
  for (std::size_t k = 0; k < 3; ++k) mapped[k] = grey + t * (2 * lightness * along[k] + t * curve[k]);
  return clip(mapped);
}

}  // namespace

std::span<const GamutMappingEntry> gamut_mappings() { return entries; }

std::optional<GamutMapping> find_gamut_mapping(std::string_view name) {
  for (const GamutMappingEntry& entry : entries)
    if (same_name(entry.name, name)) return entry.mapping;
  return {};
}

std::string_view name_of(GamutMapping mapping) {
  for (const GamutMappingEntry& entry : entries)
    if (entry.mapping == mapping) return entry.name;
  return {};
}

bool in_srgb_gamut(LinearRgb colour, double tolerance) {
  const auto inside = [tolerance](double v) { return v >= -tolerance && v <= 1 + tolerance; };
  return inside(colour.r) && inside(colour.g) && inside(colour.b);
}

LinearRgb map_to_srgb_gamut(LinearRgb colour, GamutMapping mapping) {
  if (in_srgb_gamut(colour)) return colour;
  const Vector3 rgb = finite(colour);
  switch (mapping) {
    case GamutMapping::clip:
      return clip(rgb);
    case GamutMapping::reduce_chroma:
      return in_srgb_gamut({rgb[0], rgb[1], rgb[2]}) ? clip(rgb) : reduce_chroma(rgb);
  }
  return clip(rgb);
}

}  // namespace shabon::color
