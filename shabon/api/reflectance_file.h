// The reflectance of a paint or another surface over the wavelength, from a file.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/color/spectrum.h"

namespace shabon::api {

// Comma separated values as read_spectrum_file() takes them, of which the column R (`reflectance`) counts: linear
// between its wavelengths, held at its ends. Errors as there, and Failure::content for values outside 0..1, wavelengths
// that occur twice and more than one angle.
Result<color::Spectrum> read_reflectance_file(const std::filesystem::path& path);

}  // namespace shabon::api
