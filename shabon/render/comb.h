// The wavelength comb, equation (28): a camera sample carries 16 wavelengths, evenly spaced over the observer's range
// and shifted by one of 64 shifts. Where a lamp of the scene has lines the spacing follows its power, or most combs
// would miss them. Each comb's weights are corrected so that it integrates the observer under the lamps of the scene
// exactly: a background seen directly has its exact colour in every sample.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "shabon/color/observer.h"
#include "shabon/color/spectrum.h"
#include "shabon/render/sampling.h"

namespace shabon::render {

inline constexpr int lane_count = 16;

// So many lamps, the first ones, come out exactly in every comb; a picture counts for three. The lanes could not serve
// many more; those are as exact as the comb is.
inline constexpr std::size_t most_exact_lamps = 6;

struct Comb {
  std::array<double, lane_count> wavelength_nm;
  std::array<std::array<double, lane_count>, 3> weight;  // X = sum over lanes of weight[0] * radiance
  // The same without the correction, for light of which only one lane is left.
  std::array<std::array<double, lane_count>, 3> plain_weight;
};

// Linear between the 1 nm values, the end value beyond the ends.
double at_wavelength(std::span<const double, color::spectrum_size> spectrum, double wavelength_nm);

// One comb for each of the comb_count shifts. `lamps` are the radiance spectra that are to come out exactly.
// Wavelengths rise within a comb.
std::vector<Comb> wavelength_combs(const color::Observer& observer, std::span<const color::Spectrum> lamps);

}  // namespace shabon::render
