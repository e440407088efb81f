#include "shabon/desk/film_cells.h"

#include <algorithm>

#include "shabon/desk/fringes.h"
#include "shabon/desk/kernel/sweep_rows.h"
#include "shabon/optics/reference/stack_model.h"

namespace shabon::desk {

bool can_be_cut(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence) {
  return interference == optics::Interference::airy && incidence.cos_i > 0 &&
         std::all_of(stack.layers.begin(), stack.layers.end(),
                     [](const optics::Layer& layer) { return layer.coherent; });
}

double cell_share(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence, Side side,
                  double wavelength_nm) {
  const optics::ResolvedStack resolved = optics::resolve(stack, wavelength_nm);
  if (interference != optics::Interference::none && may_have_fine_fringes(stack)) {
    const Fringes found = fringes(resolved, incidence, wavelength_nm);
    if (found.all_per_nm > most_fringes_per_nm) {
      const std::vector<double> offsets_nm = looks_within_nm(found);
      double sum = 0;
      for (const double offset_nm : offsets_nm)
        sum += unpolarised(film_powers(stack, interference, incidence, wavelength_nm + offset_nm), side);
      return sum / static_cast<double>(offsets_nm.size());
    }
  }
  return unpolarised(optics::model_powers(resolved, interference, incidence, wavelength_nm), side);
}

SweptCells::SweptCells(const Sweep& sweep) : sweep_(sweep) {
  const bool others_matter = may_have_fine_fringes(sweep.stack, sweep.layer);
  optics::ResolvedStack resolved;
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    const double middle_nm = color::wavelength_nm(i);
    first_.push_back(wavelengths_nm_.size());
    std::vector<double> offsets_nm = {0};
    if (others_matter) {
      optics::resolve(sweep.stack, middle_nm, resolved);
      offsets_nm = looks_within_nm(fringes(resolved, sweep.incidence, middle_nm, sweep.layer));
    }
    for (const double offset_nm : offsets_nm) wavelengths_nm_.push_back(middle_nm + offset_nm);
  }
  first_.push_back(wavelengths_nm_.size());
  table_ = sweep_table(sweep.stack, sweep.layer, sweep.incidence, wavelengths_nm_);
  fringes_per_nm_.assign(table_.padded, 0);
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    const double across_per_nm =
        fringes_across_per_nm(sweep.stack, sweep.layer, sweep.incidence, color::wavelength_nm(i));
    for (std::size_t row = first_[i]; row < first_[i + 1]; ++row)
      fringes_per_nm_[row] = across_per_nm / static_cast<double>(first_[i + 1] - first_[i]);
    most_fringes_per_nm_of_layer_ = std::max(most_fringes_per_nm_of_layer_, across_per_nm);
  }
}

bool SweptCells::resolved(double thickness_nm) const {
  return wavelengths_nm_.size() == color::spectrum_size &&
         most_fringes_per_nm_of_layer_ * thickness_nm <= most_fringes_per_nm;
}

color::Spectrum SweptCells::shares(double thickness_nm) const {
  std::vector<double> row(table_.padded);
  sweep_row_means(table_, sweep_.side, fringes_per_nm_, most_fringes_per_nm, thickness_nm, row);
  if (!table_.near_critical.empty()) {
    optics::Stack stack = sweep_.stack;
    stack.layers[sweep_.layer].thickness_nm = thickness_nm;
    for (const std::size_t i : table_.near_critical)
      row[i] = unpolarised(film_powers(stack, sweep_.interference, sweep_.incidence, wavelengths_nm_[i]), sweep_.side);
  }
  color::Spectrum means{};
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (std::size_t at = first_[i]; at < first_[i + 1]; ++at) means[i] += row[at];
    means[i] /= static_cast<double>(first_[i + 1] - first_[i]);
  }
  return means;
}

}  // namespace shabon::desk
