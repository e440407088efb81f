#include "shabon/desk/sweep.h"

#include <algorithm>
#include <string>

#include "shabon/base/text.h"

namespace shabon::desk {

namespace {

Status check(const Sweep& sweep) {
  if (sweep.layer >= sweep.stack.layers.size())
    return fail(Failure::content, "there is no layer " + std::to_string(sweep.layer + 1) + " to sweep: the stack has " +
                                      std::to_string(sweep.stack.layers.size()));
  for (const double thickness_nm : sweep.thicknesses_nm)
    if (!(thickness_nm >= 0 && thickness_nm <= optics::largest_thickness_nm))
      return fail(Failure::content, "expected thicknesses of 0.." + format_number(optics::largest_thickness_nm) +
                                        " nm, got " + format_number(thickness_nm));
  return check_computable(sweep.stack, sweep.interference);
}

}  // namespace

Result<std::vector<std::vector<double>>> swept_spectra(const Sweep& sweep, std::span<const double> wavelengths_nm) {
  const Status checked = check(sweep);
  if (!checked) return checked.errors();
  std::vector<std::vector<double>> spectra;
  spectra.reserve(sweep.thicknesses_nm.size());
  optics::Stack stack = sweep.stack;
  for (const double thickness_nm : sweep.thicknesses_nm) {
    stack.layers[sweep.layer].thickness_nm = thickness_nm;
    std::vector<double>& spectrum = spectra.emplace_back();
    for (const double wavelength_nm : wavelengths_nm)
      spectrum.push_back(
          unpolarised(film_powers(stack, sweep.interference, sweep.incidence, wavelength_nm), sweep.side));
  }
  return spectra;
}

Result<std::vector<color::Xyz>> swept_colors(const Sweep& sweep, const color::Illuminant& lamp,
                                             const color::Observer& observer) {
  std::vector<double> wavelengths_nm;
  for (std::size_t i = 0; i < color::spectrum_size; ++i) wavelengths_nm.push_back(color::wavelength_nm(i));
  const auto spectra = swept_spectra(sweep, wavelengths_nm);
  if (!spectra) return spectra.errors();
  std::vector<color::Xyz> colours;
  colours.reserve(spectra->size());
  for (const std::vector<double>& spectrum : *spectra)
    colours.push_back(color::reflectance_to_xyz(color::SpectrumView(spectrum), lamp, observer));
  return colours;
}

}  // namespace shabon::desk
