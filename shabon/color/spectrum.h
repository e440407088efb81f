// Spectra as the colour room sums them: one value per nanometre over the range of the CIE observers.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace shabon::color {

inline constexpr int first_nm = 360;
inline constexpr int last_nm = 830;
inline constexpr int spectrum_size = 471;
static_assert(spectrum_size == last_nm - first_nm + 1);

// Values at 360, 361, ... 830 nm (vacuum wavelengths).
using Spectrum = std::array<double, 471>;
using SpectrumView = std::span<const double, 471>;

// The wavelength of the value at `index`, 0..470.
constexpr int wavelength_nm(std::size_t index) { return first_nm + static_cast<int>(index); }

}  // namespace shabon::color
