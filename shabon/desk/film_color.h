// The colour of a film under a lamp.
#pragma once

#include <array>
#include <optional>

#include "shabon/color/adaptation.h"
#include "shabon/color/gamut.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/lab.h"
#include "shabon/color/observer.h"
#include "shabon/color/rgb.h"
#include "shabon/color/spaces.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"

namespace shabon::desk {

// How a colour becomes RGB.
struct ColorOptions {
  // From the lamp's white to that of the RGB space (44); without it, RGB shows the light as it is.
  std::optional<color::Adaptation> adaptation = {};
  color::GamutMapping mapping = color::default_gamut_mapping;  // of srgb_mapped
};

struct Color {
  color::Xyz xyz;                 // never adapted
  color::Xy xy;                   // 0, 0 for black
  color::Lab lab;                 // its white is the lamp
  color::LinearRgb linear_srgb;   // unclipped
  color::EncodedRgb srgb;         // clipped to 0..1
  color::EncodedRgb srgb_mapped;  // inside sRGB by the mapping asked for
  bool in_gamut = true;           // whether linear_srgb lies in 0..1, within color::gamut_rounding
};

// The colour of a reflectance or transmittance at 360, 361, ... 830 nm.
Color color_of(const color::Spectrum& share, const color::Illuminant& lamp,
               const color::Observer& observer = color::observer_1931(), const ColorOptions& options = {});

// Of XYZ that are known already, such as those of a sweep. `white` is color::white_point() of the lamp.
Color color_of(color::Xyz colour, color::Xyz white, const ColorOptions& options = {});

// The components of the colour in a space, RGB linear and unclipped. Adaptation concerns spaces with a white of their
// own, RGB and Oklab.
std::array<double, 3> in_space(color::ColorSpace space, color::Xyz colour, color::Xyz white,
                               std::optional<color::Adaptation> adaptation = {});

}  // namespace shabon::desk
