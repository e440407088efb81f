// A medium from a file of measured n and k, or of a dispersion formula.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::api {

// Two forms, told apart by the file's ending:
//   .yml, .yaml    a file of refractiveindex.info. Its list DATA has one entry for n (`formula 1` .. `formula 9`,
//                  `tabulated n` or `tabulated nk`) and, where the medium absorbs, one `tabulated k`. Wavelengths in
//                  micrometres, as that database has them. Other keys (CONDITIONS, PROPERTIES, SPECS, ...) say nothing
//                  here.
//   anything else  comma separated values with '#' comments: a column of wavelengths (`wavelength_nm`, `lambda_nm`,
//                  `wave_nm`, `wl_nm`, `nm`, `wavelength`, `lambda` hold nanometres; `wavelength_um`, `lambda_um`,
//                  `wave_um`, `wl_um`, `um`, `wavelength_micron` and `wl` micrometres), one of n (`n`, `index`,
//                  `refractive_index`) and, where the medium absorbs, one of k (`k`, `kappa`, `extinction`,
//                  `extinction_coefficient`), in any order; without a header wavelength in nm, n and k stand in this
//                  order. Names ignore case, blanks, '_' and brackets: `Wavelength (nm)` will do. Other columns are
//                  errors. ';' or tabs may separate the columns, and then a ',' is a decimal point. A table of n and
//                  below it one of k, as refractiveindex.info exports them, are joined.
// The wavelengths rise; n and k are >= 0. Errors: Failure::file when it cannot be read, Failure::content with line,
// column and what was expected.
Result<optics::Medium> read_nk_file(const std::filesystem::path& path);

}  // namespace shabon::api
