// The thin film of glTF 2.0: three channels, no spectrum.
#pragma once

#include "shabon/color/rgb.h"

namespace shabon::desk {

// The reflectance in linear sRGB of a film in air after KHR_materials_iridescence (Khronos Group, ratified extension of
// glTF 2.0, section "Analytic Spectral Integration"), which simplifies L. Belcour, P. Barla, "A practical extension to
// microfacet theory for the modeling of varying iridescence", ACM Trans. Graph. 36 (4), 65 (2017): walls by Schlick,
// two terms of the Airy series, Gaussians in place of the observer, negative channels set to 0. `base` is the
// reflectance of the base in air at normal incidence. The thickness in nm, the index of the film >= 1, cos_i in 0..1.
color::LinearRgb gltf_iridescence(double film_index, double thickness_nm, double cos_i, color::LinearRgb base);

}  // namespace shabon::desk
