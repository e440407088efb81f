#include "shabon/desk/film_spectrum.h"

#include <algorithm>

#include "shabon/desk/film_cells.h"
#include "shabon/desk/fringes.h"
#include "shabon/optics/reference/stack_model.h"

namespace shabon::desk {

namespace {

// Whether `media[index]` was listed before.
bool repeats(std::span<const optics::Medium> media, std::size_t index) {
  const auto before = media.first(index);
  return std::find(before.begin(), before.end(), media[index]) != before.end();
}

}  // namespace

Status check_computable(const optics::Stack& stack, optics::Interference interference) {
  return optics::check_model(stack, interference);
}

optics::Powers film_powers(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                           double wavelength_nm) {
  return optics::model_powers(stack, interference, incidence, wavelength_nm);
}

Diagnostics range_warnings(const optics::Stack& stack, std::span<const double> wavelengths_nm) {
  std::vector<optics::Medium> media{stack.incidence};
  for (const optics::Layer& layer : stack.layers) media.push_back(layer.medium);
  media.push_back(stack.exit);

  Diagnostics warnings;
  for (std::size_t i = 0; i < media.size(); ++i) {
    if (repeats(media, i)) continue;
    std::string note = media[i].outside_range_note(wavelengths_nm);
    if (note.empty()) continue;
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.message = std::move(note);
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

double unpolarised(const optics::Powers& powers, Side side) {
  return side == Side::reflected ? (powers.R_s + powers.R_p) / 2 : (powers.T_s + powers.T_p) / 2;
}

color::Spectrum unpolarised(const optics::Stack& stack, optics::Interference interference, optics::Incidence incidence,
                            Side side) {
  const auto spectrum = [&](const auto& share_at) {
    color::Spectrum share{};
    for (std::size_t i = 0; i < share.size(); ++i) share[i] = share_at(color::wavelength_nm(i));
    return share;
  };
  if (!may_have_fine_fringes(stack) || !can_be_cut(stack, interference, incidence))
    return spectrum([&](double nm) { return cell_share(stack, interference, incidence, side, nm); });
  // As a sweep of one thickness, so that a film has one colour wherever it is asked.
  const optics::ResolvedStack first = optics::resolve(stack, color::first_nm);
  const std::size_t layer = fringes(first, incidence, color::first_nm).thickest;
  const double thickness_nm = stack.layers[layer].thickness_nm;
  const Sweep sweep{stack, layer, {thickness_nm}, incidence, side, interference};
  const SweptCells cells(sweep);
  if (!cells.resolved(thickness_nm)) return cells.shares(thickness_nm);
  return spectrum([&](double nm) { return unpolarised(film_powers(stack, interference, incidence, nm), side); });
}

}  // namespace shabon::desk
