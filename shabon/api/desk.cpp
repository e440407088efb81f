#include "shabon/api/desk.h"

#include <algorithm>
#include <complex>

#include "shabon/base/text.h"
#include "shabon/color/gamut.h"
#include "shabon/optics/reference/airy.h"
#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::api {

namespace {

using optics::Interference;

using Model = optics::Powers (*)(std::complex<double> n1, std::complex<double> n2, std::complex<double> n3,
                                 double thickness_nm, optics::Incidence incidence, double wavelength_nm);

Model model_of(Interference interference) {
  switch (interference) {
    case Interference::two_beam:
      return optics::two_beam;
    case Interference::none:
      return optics::without_interference;
    case Interference::airy:
      break;
  }
  return optics::airy;
}

// Whether `media[index]` was listed before.
bool repeats(std::span<const optics::Medium> media, std::size_t index) {
  const auto before = media.first(index);
  return std::find(before.begin(), before.end(), media[index]) != before.end();
}

}  // namespace

Status check_computable(const optics::Stack& stack, Interference interference) {
  if (stack.layers.size() > 1 && interference == Interference::two_beam)
    return fail(Failure::content,
                "two-beam knows a single layer, got " + std::to_string(stack.layers.size()) + "; use airy");
  if (stack.layers.size() > 1)
    return fail(Failure::content, "stacks of several layers cannot be computed yet: expected at most one layer, got " +
                                      std::to_string(stack.layers.size()));
  if (!stack.layers.empty() && !stack.layers.front().coherent)
    return fail(Failure::content, "incoherent layers cannot be computed yet: expected one coherent layer or none");
  return Done{};
}

optics::Powers stack_powers(const optics::Stack& stack, Interference interference, optics::Incidence incidence,
                            double wavelength_nm) {
  const bool bare = stack.layers.empty();
  const optics::Medium& film = bare ? stack.exit : stack.layers.front().medium;
  const double thickness_nm = bare ? 0 : stack.layers.front().thickness_nm;
  return model_of(interference)(stack.incidence.index(wavelength_nm), film.index(wavelength_nm),
                                stack.exit.index(wavelength_nm), thickness_nm, incidence, wavelength_nm);
}

Diagnostics range_warnings(const optics::Stack& stack, std::span<const double> wavelengths_nm) {
  std::vector<optics::Medium> media{stack.incidence};
  for (const optics::Layer& layer : stack.layers) media.push_back(layer.medium);
  media.push_back(stack.exit);

  Diagnostics warnings;
  for (std::size_t i = 0; i < media.size(); ++i) {
    if (repeats(media, i)) continue;
    if (std::all_of(wavelengths_nm.begin(), wavelengths_nm.end(), [&](double nm) { return media[i].covers(nm); }))
      continue;
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.message = media[i].outside_range_note();
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

color::Spectrum unpolarised(const optics::Stack& stack, Interference interference, optics::Incidence incidence,
                            Side side) {
  color::Spectrum share{};
  for (std::size_t i = 0; i < share.size(); ++i) {
    const optics::Powers powers = stack_powers(stack, interference, incidence, color::wavelength_nm(i));
    share[i] = side == Side::reflected ? (powers.R_s + powers.R_p) / 2 : (powers.T_s + powers.T_p) / 2;
  }
  return share;
}

Color color_of(const color::Spectrum& share, const color::Illuminant& lamp, const color::Observer& observer) {
  Color result;
  result.xyz = color::reflectance_to_xyz(share, lamp, observer);
  result.xy = color::chromaticity(result.xyz);
  result.lab = color::xyz_to_lab(result.xyz, color::white_point(lamp, observer));
  result.linear_srgb = color::xyz_to_linear_srgb(result.xyz);
  result.srgb = color::encode_srgb(result.linear_srgb);
  result.srgb_mapped =
      color::encode_srgb(color::map_to_srgb_gamut(result.linear_srgb, color::GamutMapping::reduce_chroma));
  result.in_gamut = color::in_srgb_gamut(result.linear_srgb);
  return result;
}

}  // namespace shabon::api
