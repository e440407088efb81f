// Spectra for RGB pictures: three smooth basis spectra of our own, equation (22).
#pragma once

#include "shabon/color/rgb.h"
#include "shabon/color/spectrum.h"

namespace shabon::color {

// At every wavelength each value is in 0..1 and the three sum to 1. Under the tabulated D65 they have the colours of
// the sRGB primaries, scaled so that together they are its white, (1.00016, 0.99998, 0.99976) in linear sRGB. A colour
// of the picture therefore comes back within 2.5e-4 of its largest component. (The idea of I. Mallett, C. Yuksel,
// "Spectral primary decomposition for rendering with sRGB reflectance", EGSR 2019; the numbers are from
// tools/make_rgb_basis.py.)
struct RgbBasis {
  Spectrum r, g, b;
};

const RgbBasis& rgb_basis();

// c.r r + c.g g + c.b b, dimensionless: a reflectance when c is in 0..1.
Spectrum rgb_to_reflectance(LinearRgb colour);

// The same times lamp_radiance(D65): the radiance of a pixel whose linear sRGB colour is c; (1, 1, 1) has Y = 1.
Spectrum rgb_to_radiance(LinearRgb colour);

}  // namespace shabon::color
