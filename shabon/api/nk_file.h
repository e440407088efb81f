// A medium from a file of measured n and k, or of a dispersion formula.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::api {

// Two forms, told apart by the file's ending:
//   .yml, .yaml  a file of refractiveindex.info: one `DATA` entry for n (a formula or `tabulated n`/`nk`) and, where
//   the
//                medium absorbs, one `tabulated k`. Wavelengths in micrometres, as that database has them.
//   anything else  comma separated values: wavelength in nm, n and, where the medium absorbs, k. The columns are named
//                `wavelength_nm` (or `lambda_nm`), `n` and `k`, or stand in this order without a header. '#' comments.
// The wavelengths rise; n and k are >= 0. Errors: Failure::file when it cannot be read, Failure::content with the place
// of what is wrong.
Result<optics::Medium> read_nk_file(const std::filesystem::path& path);

}  // namespace shabon::api
