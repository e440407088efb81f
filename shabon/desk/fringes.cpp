#include "shabon/desk/fringes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/optics/reference/fresnel.h"

namespace shabon::desk {

namespace {

// Below this no layers of all media have fine fringes: 2 n d/wavelength^2 < 1/4 at 359.5 nm for every n up to 16.
constexpr double always_resolved_nm = 1000;

// Powers of a round trip below e^-20 are nothing.
constexpr double opaque = 20;

constexpr double looks_per_fringe = 8;
constexpr std::size_t least_looks = 4;
// Fibonacci numbers that follow each other.
constexpr std::size_t most_looks = 89, lattice_step = 55;

}  // namespace

Fringes fringes(const optics::ResolvedStack& stack, optics::Incidence incidence, double wavelength_nm,
                std::optional<std::size_t> without) {
  Fringes found;
  for (std::size_t j = 0; j < stack.layers.size(); ++j) {
    const optics::ResolvedLayer& layer = stack.layers[j];
    if (j == without || !layer.coherent) continue;
    const std::complex<double> n_c = optics::normal_index(stack.n1, incidence, layer.n);
    const double waves = layer.thickness_nm / wavelength_nm;
    if (4 * std::numbers::pi * std::abs(n_c.imag()) * waves > opaque) continue;
    const double per_nm = 2 * std::abs(n_c.real()) * waves / wavelength_nm;
    found.all_per_nm += per_nm;
    if (per_nm <= found.thickest_per_nm) continue;
    found.thickest_per_nm = per_nm;
    found.thickest = j;
  }
  return found;
}

double fringes_across_per_nm(const optics::Stack& stack, std::size_t layer, optics::Incidence incidence,
                             double middle_nm) {
  const auto round_trips_per_nm = [&](double wavelength_nm) {
    const std::complex<double> n1 = stack.incidence.index(wavelength_nm);
    const std::complex<double> n = stack.layers[layer].medium.index(wavelength_nm);
    return 2 * std::abs(optics::normal_index(n1, incidence, n).real()) / wavelength_nm;
  };
  return std::abs(round_trips_per_nm(middle_nm - 0.5) - round_trips_per_nm(middle_nm + 0.5));
}

bool may_have_fine_fringes(const optics::Stack& stack, std::optional<std::size_t> without) {
  double thickness_nm = 0;
  for (std::size_t j = 0; j < stack.layers.size(); ++j)
    if (j != without && stack.layers[j].coherent) thickness_nm += stack.layers[j].thickness_nm;
  return thickness_nm > always_resolved_nm;
}

std::vector<double> looks_within_nm(const Fringes& fringes) {
  if (fringes.all_per_nm <= most_fringes_per_nm) return {0};
  const double wanted = std::ceil(looks_per_fringe * fringes.all_per_nm);
  const bool lattice = wanted > static_cast<double>(most_looks);
  const std::size_t count = lattice ? most_looks : std::max(static_cast<std::size_t>(wanted), least_looks);
  std::vector<double> offsets_nm;
  for (std::size_t j = 0; j < count; ++j) {
    double offset_nm = (static_cast<double>(j) + 0.5) / static_cast<double>(count) - 0.5;
    if (lattice && fringes.thickest_per_nm > 1) {
      // The nearest place at which the thickest layer has the phase j 55/89.
      const double phase = static_cast<double>(j * lattice_step % count) / static_cast<double>(count);
      const double off = phase - offset_nm * fringes.thickest_per_nm;
      offset_nm += (off - std::round(off)) / fringes.thickest_per_nm;
    }
    offsets_nm.push_back(offset_nm);
  }
  return offsets_nm;
}

}  // namespace shabon::desk
