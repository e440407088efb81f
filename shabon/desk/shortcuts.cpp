#include "shabon/desk/shortcuts.h"

#include <array>
#include <cmath>
#include <complex>

#include "shabon/base/parallel.h"
#include "shabon/base/text.h"
#include "shabon/color/rgb.h"
#include "shabon/color/spectrum.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/fringes.h"
#include "shabon/desk/shortcuts_gltf.h"
#include "shabon/desk/shortcuts_walls.h"

namespace shabon::desk {

namespace {

using Colors = std::vector<color::Xyz>;

std::string_view fits_all(const Sweep&) { return {}; }

std::string_view only_one_layer(const Sweep& film) {
  return film.stack.layers.size() == 1 ? "" : "knows a single layer between two media";
}

// Air in any of its forms.
bool is_air(const optics::Medium& medium) { return std::abs(medium.index(sodium_nm) - 1.0) < 1e-3; }

std::string_view only_in_air(const Sweep& film) {
  if (film.side != Side::reflected) return "knows the reflected light only";
  if (!is_air(film.stack.incidence)) return "knows films in air only";
  if (film.stack.layers[film.layer].medium.index(sodium_nm).real() < 1) return "knows films denser than air only";
  return only_one_layer(film);
}

// Of a film that swept_colors() is known to answer.
Colors swept(Sweep film, const color::Illuminant& lamp, const color::Observer& observer,
             optics::Interference interference = optics::Interference::airy) {
  film.interference = interference;
  Result<Colors> colors = swept_colors(film, lamp, observer);
  return colors ? std::move(*colors) : Colors(film.thicknesses_nm.size());
}

std::vector<std::vector<double>> spectra(Sweep film, std::span<const double> wavelengths_nm) {
  film.interference = optics::Interference::airy;
  auto shares = swept_spectra(film, wavelengths_nm);
  if (shares) return std::move(*shares);
  return std::vector(film.thicknesses_nm.size(), std::vector<double>(wavelengths_nm.size()));
}

Colors two_beam(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  return swept(film, lamp, observer, optics::Interference::two_beam);
}

Colors no_interference(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  if (film.stack.layers.size() == 1) return swept(film, lamp, observer, optics::Interference::none);
  Sweep incoherent = film;
  for (optics::Layer& layer : incoherent.stack.layers) layer.coherent = false;
  return swept(incoherent, lamp, observer);
}

Colors no_dispersion(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  Sweep plain = film;
  const auto hold = [](optics::Medium& medium) {
    if (!medium.is_constant()) medium = optics::Medium::constant(medium.index(sodium_nm));
  };
  hold(plain.stack.incidence);
  for (optics::Layer& layer : plain.stack.layers) hold(layer.medium);
  hold(plain.stack.exit);
  return swept(plain, lamp, observer);
}

// What a program that knows three channels makes of reflectances: each times the lamp's own channel.
color::Xyz lit(color::LinearRgb share, color::LinearRgb lamp) {
  return color::linear_srgb_to_xyz({share.r * lamp.r, share.g * lamp.g, share.b * lamp.b});
}

Colors three_wavelengths(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  const color::LinearRgb white = color::xyz_to_linear_srgb(color::white_point(lamp, observer));
  Colors colors;
  for (const std::vector<double>& share : spectra(film, std::array{red_nm, green_nm, blue_nm}))
    colors.push_back(lit({share[0], share[1], share[2]}, white));
  return colors;
}

Colors gltf(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  const color::LinearRgb white = color::xyz_to_linear_srgb(color::white_point(lamp, observer));
  // What an author would give as the colour of the base: its own in air, under the same lamp.
  const optics::Stack bare{film.stack.incidence, {}, film.stack.exit};
  const color::LinearRgb seen = color::xyz_to_linear_srgb(
      color::reflectance_to_xyz(unpolarised(bare, optics::Interference::airy, {}, Side::reflected), lamp, observer));
  const color::LinearRgb base{seen.r / white.r, seen.g / white.g, seen.b / white.b};
  const double index = film.stack.layers[film.layer].medium.index(sodium_nm).real();
  Colors colors;
  for (const double thickness_nm : film.thicknesses_nm)
    colors.push_back(lit(gltf_iridescence(index, thickness_nm, film.incidence.cos_i, base), white));
  return colors;
}

Colors films_of_walls(WallAmplitude amplitude, const Sweep& film, const color::Illuminant& lamp,
                      const color::Observer& observer) {
  std::vector<FilmOfWalls> films;
  std::vector<double> fringes_per_nm;
  for (std::size_t i = 0; i < color::spectrum_size; ++i) {
    const double nm = color::wavelength_nm(i);
    films.emplace_back(amplitude, film.stack.incidence.index(nm), film.stack.layers[0].medium.index(nm),
                       film.stack.exit.index(nm), film.incidence, nm);
    fringes_per_nm.push_back(fringes_across_per_nm(film.stack, 0, film.incidence, nm));
  }
  Colors colors(film.thicknesses_nm.size());
  parallel_for(colors.size(), 0, [&](std::size_t t) {
    color::Spectrum share{};
    for (std::size_t i = 0; i < color::spectrum_size; ++i) {
      const double thickness_nm = film.thicknesses_nm[t];
      const WallShares shares = films[i].mean(thickness_nm, fringes_per_nm[i] * thickness_nm);
      share[i] = film.side == Side::reflected ? shares.reflected : shares.transmitted;
    }
    colors[t] = color::reflectance_to_xyz(share, lamp, observer);
  });
  return colors;
}

Colors schlick(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  return films_of_walls(schlick_amplitude, film, lamp, observer);
}

Colors unpolarised_walls(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  return films_of_walls(average_amplitude, film, lamp, observer);
}

// (17) with a tenth of the terms.
Colors coarse_sampling(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer) {
  std::vector<double> wavelengths_nm;
  std::vector<color::Xyz> weights;
  double perfect = 0;
  for (int nm = coarse_first_nm; nm <= coarse_last_nm; nm += coarse_step_nm) {
    const auto i = static_cast<std::size_t>(nm - color::first_nm);
    wavelengths_nm.push_back(nm);
    weights.push_back({lamp.power[i] * observer.x[i], lamp.power[i] * observer.y[i], lamp.power[i] * observer.z[i]});
    perfect += weights.back().y;
  }
  Colors colors;
  for (const std::vector<double>& share : spectra(film, wavelengths_nm)) {
    color::Xyz& sum = colors.emplace_back();
    for (std::size_t i = 0; i < share.size(); ++i) {
      sum.x += share[i] * weights[i].x / perfect;
      sum.y += share[i] * weights[i].y / perfect;
      sum.z += share[i] * weights[i].z / perfect;
    }
  }
  return colors;
}

// The closed set. Numbers in the descriptions: the constants of the header.
constexpr std::array<Shortcut, 8> list = {{
    {"two-beam", "the first two reflected beams, or the transmitted one, in place of the whole series",
     "textbooks, small shaders; N. Yokoi, Y. Suzuki, J. Toriwaki (1989)", only_one_layer, two_beam},
    {"three-wavelengths", "exact at 650, 510 and 475 nm, taken as linear red, green and blue, times the lamp's RGB",
     "the usual soap-bubble shader, with these or similar wavelengths", fits_all, three_wavelengths},
    {"gltf-iridescence", "Schlick walls, two terms of the series, Gaussians in place of the observer; one index",
     "glTF 2.0 KHR_materials_iridescence, its sample viewer, three.js", only_in_air, gltf},
    {"schlick", "both walls by Schlick's polynomial, without polarisation; the rest exact",
     "real-time renderers; C. Schlick (1994)", only_one_layer, schlick},
    {"unpolarised-walls", "s and p averaged at each wall before the series is summed; the rest exact",
     "renderers that hand one Fresnel number to the film", only_one_layer, unpolarised_walls},
    {"no-dispersion", "every index held at its value at 589.3 nm; the rest exact",
     "nearly all shaders and renderers: one index for a film", fits_all, no_dispersion},
    {"no-interference", "intensities of all internal reflections summed, no phase",
     "renderers that treat a film as a thin pane", fits_all, no_interference},
    {"coarse-sampling", "exact, but 380 to 780 nm in steps of 10 nm in place of 1 nm",
     "spectral renderers and spreadsheets with short tables", fits_all, coarse_sampling},
}};

}  // namespace

std::span<const Shortcut> shortcuts() { return list; }

const Shortcut* find_shortcut(std::string_view name) {
  for (const Shortcut& shortcut : list)
    if (same_name(shortcut.name, name)) return &shortcut;
  return nullptr;
}

}  // namespace shabon::desk
