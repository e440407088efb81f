#include "shabon/color/gamut.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/color/gamut_line.h"

namespace shabon::color {

namespace {

// Beyond any exposure; keeps infinity out of the arithmetic.
constexpr double far_outside = 1e9;

// How much a colour's chroma draws its grey from its own lightness to that of its hue's cusp, (20). At 1 the mean
// CIEDE2000 between film colours and what stands for them is near its least, and no lightness is given up needlessly.
constexpr double draw_to_cusp = 1;
// Colours so dark for their chroma as no light can be draw no further, so that black stays the limit of the dark.
constexpr double most_chroma_per_lightness = 2;

// The share of the way from the grey to the boundary within which `gentle` leaves colours alone.
constexpr double knee = 0.8;

constexpr GamutMappingEntry entries[] = {
    {GamutMapping::clip, "clip", "each component is clipped to 0..1", true},
    {GamutMapping::reduce_chroma, "reduce-chroma",
     "lightness and, nearly, hue stay; chroma shrinks to the boundary of sRGB", true},
    {GamutMapping::keep_hue, "keep-hue",
     "hue stays, nearly; chroma, and lightness where chroma alone would be lost, shrink to the boundary of sRGB", true},
    {GamutMapping::gentle, "gentle",
     "as keep-hue, but without an edge at the boundary: the outermost fifth of sRGB makes room for what lies beyond",
     false},
};

Vector3 finite(LinearRgb colour) {
  constexpr auto bounded = [](double v) { return std::isnan(v) ? 0.0 : std::clamp(v, -far_outside, far_outside); };
  return {bounded(colour.r), bounded(colour.g), bounded(colour.b)};
}

LinearRgb clip(const Vector3& rgb) {
  return {std::clamp(rgb[0], 0.0, 1.0), std::clamp(rgb[1], 0.0, 1.0), std::clamp(rgb[2], 0.0, 1.0)};
}

double same_lightness(const RootColor& colour) { return colour.lightness; }

// Between the colour's own lightness (a grey stays what it is, up to white) and its cusp's. The form is that of
// B. Ottosson, "sRGB gamut clipping" (2021), adaptive L0 with the cusp.
double between_lightness_and_cusp(const RootColor& colour) {
  if (colour.chroma == 0) return colour.lightness;
  const double cusp = cusp_lightness(colour.a, colour.b), off = colour.lightness - cusp;
  const double room = 2 * (off > 0 ? 1 - cusp : cusp);
  const double chroma = std::min(colour.chroma, most_chroma_per_lightness * colour.lightness);
  const double e = room / 2 + std::abs(off) + draw_to_cusp * chroma / room;
  const double root = std::sqrt(std::max(0.0, e * e - 2 * room * std::abs(off)));
  return cusp + room * off / (e + root);
}

// Equation (20): along the line from a grey to the colour, as far as `reach` of the exit allows.
template <class Grey, class Reach>
LinearRgb along_line(const Vector3& rgb, Grey grey, Reach reach) {
  const RootColor colour = root_color(rgb);
  if (colour.lightness <= 0) return {0, 0, 0};
  const double grey_lightness = grey(colour);
  if (grey_lightness >= 1) return {1, 1, 1};
  const GamutLine line(colour, grey_lightness);
  return clip(line.at(reach(line.exit())));
}

double up_to_boundary(double exit) { return std::min(1.0, exit); }

// With r = 1/exit, the colour's distance from the grey in units of the boundary's: r below the knee, and from there
// with the same slope towards 1, which only an infinitely far colour reaches.
double with_soft_knee(double exit) {
  const double beyond = (1 / exit - knee) / (1 - knee);
  return beyond <= 0 ? 1 : (knee + (1 - knee) * beyond / (1 + beyond)) * exit;
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
  const Vector3 rgb = finite(colour);
  if (mapping == GamutMapping::gentle) return along_line(rgb, between_lightness_and_cusp, with_soft_knee);
  if (in_srgb_gamut(colour)) return colour;
  if (mapping == GamutMapping::clip || in_srgb_gamut({rgb[0], rgb[1], rgb[2]})) return clip(rgb);
  return mapping == GamutMapping::reduce_chroma ? along_line(rgb, same_lightness, up_to_boundary)
                                                : along_line(rgb, between_lightness_and_cusp, up_to_boundary);
}

}  // namespace shabon::color
