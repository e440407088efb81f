// A measured spectrum of a film from a file.
#pragma once

#include <filesystem>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/desk/thickness_spectrum.h"

namespace shabon::api {

struct SpectrumFileOptions {
  std::vector<desk::Quantity> columns;  // the only ones to read; otherwise all that are found
  bool percent = false;                 // of all columns
  double incidence_deg = 0;             // where the file has no angles
};

// Comma separated values with a header: wavelength_nm (or _um), any of R, R_s, R_p, T, T_s, T_p (also `reflectance`,
// `transmittance`), perhaps angle_deg; what `shabon spectrum` prints is one. Names ignore case, blanks and punctuation;
// a share whose name holds `%` or `percent` is in percent. Other columns are passed over, and R where R_s and R_p are
// there too. Without a header: wavelength in nm, and the share that `columns` names or else R. Wavelengths in any order
// and at any spacing. Where `;` or tabs separate the first line, they do so everywhere, and a comma is a decimal one.
// Errors: Failure::file when it cannot be read, Failure::content with the place of what is wrong, such as a share above
// 1.5 that is not said to be in percent, or more than 20 000 rows.
Result<desk::MeasuredSpectrum> read_spectrum_file(const std::filesystem::path& path,
                                                  const SpectrumFileOptions& options = {});

}  // namespace shabon::api
