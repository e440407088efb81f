// The colour of a film under a lamp.
#pragma once

#include "shabon/color/illuminant.h"
#include "shabon/color/lab.h"
#include "shabon/color/observer.h"
#include "shabon/color/rgb.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"

namespace shabon::desk {

struct Color {
  color::Xyz xyz;
  color::Xy xy;                   // 0, 0 for black
  color::Lab lab;                 // its white is the lamp
  color::LinearRgb linear_srgb;   // unclipped
  color::EncodedRgb srgb;         // clipped to 0..1
  color::EncodedRgb srgb_mapped;  // hue and lightness kept where the colour lies outside sRGB
  bool in_gamut = true;           // whether linear_srgb lies in 0..1
};

// The colour of a reflectance or transmittance at 360, 361, ... 830 nm.
Color color_of(const color::Spectrum& share, const color::Illuminant& lamp,
               const color::Observer& observer = color::observer_1931());

}  // namespace shabon::desk
