// A lamp from a file of measured powers.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"

namespace shabon::api {

// Comma separated values: rising wavelengths in nm and powers >= 0 per nm on any scale, at any spacing. The columns are
// named `wavelength_nm` (or `lambda_nm`, or `_um`) and `power`, or are the only two, with or without a header. `;` or
// tabs may separate them, and then a comma is a decimal one, as in n-k files. '#' comments become the lamp's source.
// Between the samples the spectrum is linear, beyond them zero; `note` tells so. Its name is the file's. Errors:
// Failure::file when it cannot be read, Failure::content with the place of what is wrong.
Result<color::Illuminant> read_lamp_file(const std::filesystem::path& path);

}  // namespace shabon::api
