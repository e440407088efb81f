#include <algorithm>
#include <cmath>

#include "bench/optics/film_kernels.h"
#include "shabon/color/observer.h"
#include "shabon/render/comb.h"

namespace shabon::bench {

namespace {

// What one wall and the way through the film need, for one index.
template <class Number>
struct Walls {
  Number rho_s, rho_p, phase_nm;  // the phase is phase_nm / wavelength
};

template <class Number>
Walls<Number> walls(Number n, Number cos_1, Number thickness_nm) {
  const Number cos_2 = std::sqrt(1 - (1 - cos_1 * cos_1) / (n * n));
  const Number r_s = (cos_1 - n * cos_2) / (cos_1 + n * cos_2), r_p = (n * cos_1 - cos_2) / (n * cos_1 + cos_2);
  return {r_s * r_s, r_p * r_p, 4 * std::numbers::pi_v<Number> * n * cos_2 * thickness_nm};
}

}  // namespace

template <class Number>
PlainFilm<Number>::PlainFilm(const scene::Scene& scene)
    : dispersive_(!scene.films.front().layers.front().medium.is_constant()) {
  for (const render::Comb& comb : render::wavelength_combs(color::observer_1931(), scene.environment.channels)) {
    auto& wavelengths = wavelength_nm_.emplace_back();
    auto& indices = index_.emplace_back();
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
      wavelengths[i] = static_cast<Number>(comb.wavelength_nm[i]);
      indices[i] = static_cast<Number>(scene.films.front().layers.front().medium.index(comb.wavelength_nm[i]).real());
    }
  }
}

template <class Number>
template <class Reflectance>
double PlainFilm<Number>::mean(const FilmEvents& events, const Reflectance& reflectance) const {
  double total = 0;
  for (int i = 0; i < event_count; ++i) {
    const auto event = static_cast<std::size_t>(i);
    const std::size_t comb = comb_of_block(i / block_size);
    const Number cos_i = static_cast<Number>(events.cos_i[event]);
    const Number thickness_nm = static_cast<Number>(events.thickness_nm[event]);
    Walls<Number> at = walls(index_[comb][0], cos_i, thickness_nm);
    Number sum = 0;
    for (std::size_t lane = 0; lane < 16; ++lane) {
      if (dispersive_) at = walls(index_[comb][lane], cos_i, thickness_nm);
      const Number cosine = std::cos(at.phase_nm / wavelength_nm_[comb][lane]);
      sum += (reflectance(at.rho_s, cosine) + reflectance(at.rho_p, cosine)) / 2;
    }
    total += static_cast<double>(sum);
  }
  return total / (event_count * 16.0);
}

// |(7)|^2 of the lossless film between equal media.
template <class Number>
double PlainFilm<Number>::airy(const FilmEvents& events) const {
  return mean(events,
              [](Number rho, Number cosine) { return 2 * rho * (1 - cosine) / (1 + rho * rho - 2 * rho * cosine); });
}

// |(11)|^2, clamped as in (13).
template <class Number>
double PlainFilm<Number>::two_beam(const FilmEvents& events) const {
  return mean(events, [](Number rho, Number cosine) {
    const Number pass = 1 - rho;
    return std::min(Number(1), rho * (1 + pass * pass - 2 * pass * cosine));
  });
}

template class PlainFilm<double>;
template class PlainFilm<float>;

}  // namespace shabon::bench
