#include "shabon/render/kernel/probe_films.h"

#include <algorithm>
#include <cmath>

#include "shabon/optics/reference/mueller.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

template <class Function>
ProbeLanes per_lane(Function&& value) {
  std::array<double, probe_lanes> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = value(i);
  return ProbeLanes::load(lanes.data());
}

// The models other than airy have walls at any thickness; where there is no film there are none.
ProbeMueller no_film() {
  const ProbeLanes zero(0.0), one(1.0);
  return {{zero, zero, zero, zero}, {one, zero, one, zero}};
}

}  // namespace

WavelengthGroup::WavelengthGroup(std::span<const double> wavelengths_nm) {
  for (std::size_t i = 0; i < nm.size(); ++i) nm[i] = wavelengths_nm[std::min(i, wavelengths_nm.size() - 1)];
}

ProbeFilms::ProbeFilms(const scene::Scene& scene, const WavelengthGroup& wavelengths)
    : interference_(scene.render.interference), wavelengths_(wavelengths) {
  const auto index_of = [&](const optics::Medium& medium) {
    std::array<std::complex<double>, probe_lanes> n;
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = medium.index(wavelengths.nm[i]);
    return n;
  };
  n1_ = index_of(scene.medium);
  n1_squared_ = per_lane([&](std::size_t i) { return n1_[i].real() * n1_[i].real(); });
  for (const scene::Film& film : scene.films) {
    Film& table = films_.emplace_back();
    const bool exact = interference_ == optics::Interference::airy;
    table.n = index_of(film.layers.front().medium);
    table.free = exact && film.layers.size() == 1;
    for (std::size_t i = 0; i < table.n.size(); ++i)
      table.free = table.free && table.n[i].imag() == 0 && n1_[i].imag() == 0 && table.n[i].real() >= n1_[i].real();
    table.n2_squared = per_lane([&](std::size_t i) { return table.n[i].real() * table.n[i].real(); });
    table.indices = optics::exact_free_film_indices(n1_squared_, table.n2_squared);
    table.varied_layer = film.varied_layer;
    if (exact && !table.free)
      table.stack.emplace(optics::Stack{scene.medium, film.layers, scene.medium}, wavelengths.nm);
  }
}

ProbeMueller ProbeFilms::blocks(std::size_t index, double thickness_nm, double cos_i, bool from_inside) const {
  const Film& film = films_[index];
  if (film.stack)
    return optics::exact_stack_mueller<probe_lanes>(
        *film.stack, 0,
        {.cos_i = cos_i, .from_exit = from_inside, .layer = film.varied_layer, .thickness_nm = thickness_nm});
  if (interference_ != optics::Interference::airy && thickness_nm == 0) return no_film();
  return film.free ? free_film(film, thickness_nm, cos_i) : by_reference(film, thickness_nm, cos_i);
}

ProbeMueller ProbeFilms::free_film(const Film& film, double thickness_nm, double cos_i) const {
  const ProbeLanes q1_squared = n1_squared_ * (cos_i * cos_i), q2_squared = film.n2_squared - n1_squared_ + q1_squared;
  const optics::FreeFilmAngle<ProbeLanes> angle{q1_squared, q2_squared, n1_squared_ * ((1 - cos_i) * (1 + cos_i))};
  const ProbeLanes cycles = sqrt(q2_squared) * thickness_nm / ProbeLanes::load(wavelengths_.nm.data());  // (6)
  return optics::free_film_mueller(optics::free_film_factors(film.indices, angle),
                                   optics::free_film_turn(film.indices, angle), optics::film_phase<double>(cycles));
}

ProbeMueller ProbeFilms::by_reference(const Film& film, double thickness_nm, double cos_i) const {
  const optics::Incidence incidence = optics::incidence_from_cos(cos_i);
  std::array<optics::FilmRows, probe_lanes> rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] =
        i > 0 && wavelengths_.nm[i] == wavelengths_.nm[i - 1]
            ? rows[i - 1]
            : optics::film_rows(interference_, n1_[i], film.n[i], n1_[i], thickness_nm, incidence, wavelengths_.nm[i]);
  const auto block = [&](optics::MuellerRow optics::FilmRows::*part) {
    return optics::MuellerBlock<probe_lanes, double>{per_lane([&](std::size_t i) { return (rows[i].*part).a; }),
                                                     per_lane([&](std::size_t i) { return (rows[i].*part).b; }),
                                                     per_lane([&](std::size_t i) { return (rows[i].*part).c; }),
                                                     per_lane([&](std::size_t i) { return (rows[i].*part).d; })};
  };
  return {block(&optics::FilmRows::reflected), block(&optics::FilmRows::transmitted)};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
