#include "shabon/desk/sweep.h"

#include <algorithm>
#include <string>

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/desk/kernel/sweep_rows.h"
#include "shabon/desk/kernel/sweep_table.h"

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

// Whether (45) holds: one system of waves from the first medium to the last.
bool can_be_cut(const Sweep& sweep) {
  return sweep.interference == optics::Interference::airy && sweep.incidence.cos_i > 0 &&
         std::all_of(sweep.stack.layers.begin(), sweep.stack.layers.end(),
                     [](const optics::Layer& layer) { return layer.coherent; });
}

// The share by the reference, one thickness and wavelength at a time.
class OneByOne {
 public:
  explicit OneByOne(const Sweep& sweep) : sweep_(sweep), stack_(sweep.stack) {}

  double share(double thickness_nm, double wavelength_nm) {
    stack_.layers[sweep_.layer].thickness_nm = thickness_nm;
    return unpolarised(film_powers(stack_, sweep_.interference, sweep_.incidence, wavelength_nm), sweep_.side);
  }

 private:
  const Sweep& sweep_;
  optics::Stack stack_;
};

std::vector<std::vector<double>> spectra_one_by_one(const Sweep& sweep, std::span<const double> wavelengths_nm) {
  std::vector<std::vector<double>> spectra(sweep.thicknesses_nm.size());
  parallel_for(spectra.size(), 0, [&](std::size_t t) {
    OneByOne film(sweep);
    for (const double wavelength_nm : wavelengths_nm)
      spectra[t].push_back(film.share(sweep.thicknesses_nm[t], wavelength_nm));
  });
  return spectra;
}

std::vector<double> visible_wavelengths_nm() {
  std::vector<double> wavelengths_nm;
  for (std::size_t i = 0; i < color::spectrum_size; ++i) wavelengths_nm.push_back(color::wavelength_nm(i));
  return wavelengths_nm;
}

// (17) as weights.
XyzRows xyz_rows(const color::Illuminant& lamp, const color::Observer& observer, std::size_t padded) {
  const double perfect = color::radiance_to_xyz(lamp.power, observer).y;
  XyzRows rows;
  for (std::vector<double>* row : {&rows.x, &rows.y, &rows.z}) row->assign(padded, 0);
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    rows.x[i] = lamp.power[i] * observer.x[i] / perfect;
    rows.y[i] = lamp.power[i] * observer.y[i] / perfect;
    rows.z[i] = lamp.power[i] * observer.z[i] / perfect;
  }
  return rows;
}

std::vector<color::Xyz> colours_one_by_one(const Sweep& sweep, const color::Illuminant& lamp,
                                           const color::Observer& observer) {
  std::vector<color::Xyz> colours;
  for (const std::vector<double>& spectrum : spectra_one_by_one(sweep, visible_wavelengths_nm()))
    colours.push_back(color::reflectance_to_xyz(color::SpectrumView(spectrum), lamp, observer));
  return colours;
}

}  // namespace

Result<std::vector<std::vector<double>>> swept_spectra(const Sweep& sweep, std::span<const double> wavelengths_nm) {
  const Status checked = check(sweep);
  if (!checked) return checked.errors();
  if (!can_be_cut(sweep)) return spectra_one_by_one(sweep, wavelengths_nm);

  const SweepTable table = sweep_table(sweep.stack, sweep.layer, sweep.incidence, wavelengths_nm);
  std::vector<std::vector<double>> spectra;
  spectra.reserve(sweep.thicknesses_nm.size());
  std::vector<double> row(table.padded);
  OneByOne film(sweep);
  for (const double thickness_nm : sweep.thicknesses_nm) {
    sweep_row(table, sweep.side, thickness_nm, row);
    for (const std::size_t i : table.near_critical) row[i] = film.share(thickness_nm, wavelengths_nm[i]);
    spectra.emplace_back(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(table.wavelengths));
  }
  return spectra;
}

Result<std::vector<color::Xyz>> swept_colors(const Sweep& sweep, const color::Illuminant& lamp,
                                             const color::Observer& observer) {
  const Status checked = check(sweep);
  if (!checked) return checked.errors();
  if (!can_be_cut(sweep)) return colours_one_by_one(sweep, lamp, observer);

  const std::vector<double> wavelengths_nm = visible_wavelengths_nm();
  const SweepTable table = sweep_table(sweep.stack, sweep.layer, sweep.incidence, wavelengths_nm);
  const XyzRows weights = xyz_rows(lamp, observer, table.padded);
  std::vector<color::Xyz> colours(sweep.thicknesses_nm.size());
  sweep_xyz(table, sweep.side, weights, sweep.thicknesses_nm, colours);
  OneByOne film(sweep);
  for (const std::size_t i : table.near_critical) {
    for (std::size_t t = 0; t < colours.size(); ++t) {
      const double share = film.share(sweep.thicknesses_nm[t], wavelengths_nm[i]);
      colours[t].x += weights.x[i] * share, colours[t].y += weights.y[i] * share, colours[t].z += weights.z[i] * share;
    }
  }
  return colours;
}

}  // namespace shabon::desk
