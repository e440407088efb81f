// The reference desk: what a plane stack reflects and transmits, and what colour that is. Double precision throughout.
#pragma once

#include <span>

#include "shabon/base/result.h"
#include "shabon/color/lab.h"
#include "shabon/color/rgb.h"
#include "shabon/color/xyz.h"
#include "shabon/optics/incidence.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/stack.h"

namespace shabon::api {

// Whether stack_powers() can compute the stack: none or one coherent layer. The error says what is missing.
Status check_computable(const optics::Stack& stack, optics::Interference interference);

// R and T per polarisation at a vacuum wavelength (> 0), for a stack that passed check_computable(). A bare interface
// counts as a film of no thickness. `two_beam` is unclamped: R may exceed 1, and R + T need not be 1 without loss.
optics::Powers stack_powers(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                            double wavelength_nm);

// One warning for every medium that is asked for beyond the wavelengths its source covers.
Diagnostics range_warnings(const optics::Stack& stack, std::span<const double> wavelengths_nm);

enum class Side { reflected, transmitted };

// The unpolarised share of light, (s + p)/2, at 360, 361, ... 830 nm.
color::Spectrum unpolarised(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                            Side side);

// The colour of a reflectance or transmittance under a lamp.
struct Color {
  color::Xyz xyz;
  color::Xy xy;                   // 0, 0 for black
  color::Lab lab;                 // its white is the lamp
  color::LinearRgb linear_srgb;   // unclipped
  color::EncodedRgb srgb;         // clipped to 0..1
  color::EncodedRgb srgb_mapped;  // hue and lightness kept where the colour lies outside sRGB
  bool in_gamut = true;           // whether linear_srgb lies in 0..1
};

Color color_of(const color::Spectrum& share, const color::Illuminant& lamp,
               const color::Observer& observer = color::observer_1931());

}  // namespace shabon::api
