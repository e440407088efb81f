#include "shabon/api/reflectance_file.h"

#include <algorithm>

#include "shabon/api/spectrum_file.h"
#include "shabon/base/text.h"

namespace shabon::api {

namespace {

Diagnostics error_in(const std::filesystem::path& path, std::string message) {
  Diagnostics errors = fail(Failure::content, std::move(message));
  errors.front().source = path.string();
  return errors;
}

}  // namespace

Result<color::Spectrum> read_reflectance_file(const std::filesystem::path& path) {
  Result<desk::MeasuredSpectrum> measured = read_spectrum_file(path, {.columns = {desk::Quantity::R}});
  if (!measured) return measured.errors();
  std::vector<desk::MeasuredRow>& rows = measured->rows;
  if (rows.empty()) return error_in(path, "expected rows of reflectances, got none");
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.wavelength_nm < b.wavelength_nm; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string place = " at " + format_number(rows[i].wavelength_nm) + " nm";
    const double share = rows[i].shares.front();
    if (!(share >= 0 && share <= 1))
      return error_in(path, "expected a reflectance of 0..1, got " + format_number(share) + place);
    if (rows[i].incidence_deg != rows.front().incidence_deg)
      return error_in(path, "expected reflectances at one angle, got two");
    if (i > 0 && rows[i].wavelength_nm == rows[i - 1].wavelength_nm)
      return error_in(path, "expected one reflectance for each wavelength, got two" + place);
  }
  color::Spectrum spectrum;
  std::size_t right = 0;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double nm = color::wavelength_nm(i);
    while (right < rows.size() && rows[right].wavelength_nm < nm) ++right;
    const desk::MeasuredRow& b = rows[std::min(right, rows.size() - 1)];
    const desk::MeasuredRow& a = right == 0 ? b : rows[right - 1];
    const double span = b.wavelength_nm - a.wavelength_nm;
    const double t = span > 0 ? (nm - a.wavelength_nm) / span : 0;
    spectrum[i] = a.shares.front() + t * (b.shares.front() - a.shares.front());
  }
  return spectrum;
}

}  // namespace shabon::api
