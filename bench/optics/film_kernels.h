// The renderer's film packets, and plain loops that compute the same reflectances. No packet shows here: the sources
// are compiled for each kind of machine. Every loop returns the mean over all events and lanes of the unpolarised
// reflectance, so that their results can be compared.
#pragma once

#include <memory>

#include "bench/optics/film_events.h"
#include "shabon/scene/scene.h"

namespace shabon::bench {

class FilmPackets {
 public:
  explicit FilmPackets(const scene::Scene& scene);  // its first film
  ~FilmPackets();

  // R and T of s and p, as the renderer computes them for paths in one plane.
  double powers(const FilmEvents& events) const;

  // Turns a Stokes row into the plane of incidence and multiplies it by both Mueller blocks; not of the paper's film,
  // which averages the polarisations.
  double stokes_rows(const FilmEvents& events) const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

// One wavelength at a time with std::cos, in Number = double or float. `dispersive` computes the angle and the walls
// anew for each wavelength, else once for each event.
template <class Number>
class PlainFilm {
 public:
  explicit PlainFilm(const scene::Scene& scene);
  double airy(const FilmEvents& events) const;
  double two_beam(const FilmEvents& events) const;

 private:
  template <class Reflectance>
  double mean(const FilmEvents& events, const Reflectance& reflectance) const;
  bool dispersive_;
  std::vector<std::array<Number, 16>> wavelength_nm_, index_;  // per comb
};

extern template class PlainFilm<double>;
extern template class PlainFilm<float>;

}  // namespace shabon::bench
