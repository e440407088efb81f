// Colours of a birefringent plate between crossed polarisers: what the Michel-Levy chart shows.
#pragma once

#include <span>
#include <vector>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/spectrum.h"
#include "shabon/color/xyz.h"

namespace shabon::desk {

// The retardation at which one order of interference ends and the next begins, beside the sensitive tint: the first
// order is 0..550 nm. Source: B. E. Sorensen, "A revised Michel-Levy interference colour chart based on
// first-principles calculations", European Journal of Mineralogy 25 (2013) 5-10.
inline constexpr double order_retardation_nm = 550;

// Path difference of the two rays after a plate (>= 0), nm: birefringence (dimensionless) times thickness in nm.
double retardation_nm(double birefringence, double thickness_nm);

// The share of the light, relative to parallel polarisers without a plate, that crossed polarisers pass when the plate
// lies at 45 degrees between them: sin^2(pi retardation / wavelength), at 360, 361, ... 830 nm. The retardation in nm,
// of any size; the same for all wavelengths, so dispersion of the birefringence is left out. Nothing is reflected or
// absorbed.
color::Spectrum crossed_polars_share(double retardation_nm);

// The colours of these retardations (17); Y = 1 is the open field between parallel polarisers.
std::vector<color::Xyz> retardation_colors(std::span<const double> retardations_nm, const color::Illuminant& lamp,
                                           const color::Observer& observer = color::observer_1931());

}  // namespace shabon::desk
