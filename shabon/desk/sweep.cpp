#include "shabon/desk/sweep.h"

#include <algorithm>
#include <string>

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/desk/film_cells.h"
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
  std::vector<color::Xyz> colours(sweep.thicknesses_nm.size());
  parallel_for(colours.size(), 0, [&](std::size_t t) {
    optics::Stack stack = sweep.stack;
    stack.layers[sweep.layer].thickness_nm = sweep.thicknesses_nm[t];
    color::Spectrum share{};
    for (std::size_t i = 0; i < share.size(); ++i)
      share[i] = cell_share(stack, sweep.interference, sweep.incidence, sweep.side, color::wavelength_nm(i));
    colours[t] = color::reflectance_to_xyz(share, lamp, observer);
  });
  return colours;
}

// Of thicknesses at which one wavelength stands for each nanometre.
std::vector<color::Xyz> colours_of_table(const Sweep& sweep, const SweepTable& table,
                                         std::span<const double> thicknesses_nm, const color::Illuminant& lamp,
                                         const color::Observer& observer) {
  const XyzRows weights = xyz_rows(lamp, observer, table.padded);
  std::vector<color::Xyz> colours(thicknesses_nm.size());
  sweep_xyz(table, sweep.side, weights, thicknesses_nm, colours);
  OneByOne film(sweep);
  for (const std::size_t i : table.near_critical) {
    for (std::size_t t = 0; t < colours.size(); ++t) {
      const double share = film.share(thicknesses_nm[t], color::wavelength_nm(i));
      colours[t].x += weights.x[i] * share, colours[t].y += weights.y[i] * share, colours[t].z += weights.z[i] * share;
    }
  }
  return colours;
}

}  // namespace

Result<std::vector<std::vector<double>>> swept_spectra(const Sweep& sweep, std::span<const double> wavelengths_nm) {
  const Status checked = check(sweep);
  if (!checked) return checked.errors();
  if (!can_be_cut(sweep.stack, sweep.interference, sweep.incidence)) return spectra_one_by_one(sweep, wavelengths_nm);

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
  if (!can_be_cut(sweep.stack, sweep.interference, sweep.incidence)) return colours_one_by_one(sweep, lamp, observer);

  const SweptCells cells(sweep);
  std::vector<double> resolved_nm;
  for (const double thickness_nm : sweep.thicknesses_nm)
    if (cells.resolved(thickness_nm)) resolved_nm.push_back(thickness_nm);
  std::vector<color::Xyz> resolved;
  if (!resolved_nm.empty()) resolved = colours_of_table(sweep, cells.table(), resolved_nm, lamp, observer);
  if (resolved.size() == sweep.thicknesses_nm.size()) return resolved;

  std::vector<color::Xyz> colours;
  std::size_t next = 0;
  for (const double thickness_nm : sweep.thicknesses_nm)
    colours.push_back(cells.resolved(thickness_nm)
                          ? resolved[next++]
                          : color::reflectance_to_xyz(cells.shares(thickness_nm), lamp, observer));
  return colours;
}

}  // namespace shabon::desk
