// What a film does to light at one event: reflectance and transmittance of s and p for a path in one plane, the Mueller
// blocks for any other.
#pragma once

#include "shabon/optics/packet/stack.h"
#include "shabon/render/kernel/event_block.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using Powers = optics::FilmPowers<lane_count>;
using Mueller = optics::FilmMueller<lane_count>;

// The paper's means over the polarisations, equation (13), with the reflectances clamped to 1.
inline Powers wall_averages(const Powers& p) {
  const Lanes one(1.0f), half(0.5f);
  const Lanes reflected = half * (min(p.R_s, one) + min(p.R_p, one)), transmitted = half * (p.T_s + p.T_p);
  return {reflected, reflected, transmitted, transmitted};
}

// The incoherent sum over the passes, equation (14), as Mueller blocks: the passes do not interfere with each other,
// but s and p of one pass keep their phase.
inline Mueller without_phase_mueller(const Powers& p, const Lanes& rho_sp, const Lanes& pass_sp) {
  const Lanes half(0.5f), zero(0.0f);
  const Lanes through = pass_sp / (Lanes(1.0f) - rho_sp * rho_sp);
  return {{half * (p.R_s + p.R_p), half * (p.R_s - p.R_p), rho_sp + rho_sp * through, zero},
          {half * (p.T_s + p.T_p), half * (p.T_s - p.T_p), through, zero}};
}

// The same share of s and p at every wavelength.
inline Mueller grey_mueller(float reflectance) {
  const Lanes R(reflectance), T(1 - reflectance), zero(0.0f);
  return {{R, zero, -R, zero}, {T, zero, T, zero}};
}

inline Powers powers_of(const Mueller& m) {
  return {m.reflected.a + m.reflected.b, m.reflected.a - m.reflected.b, m.transmitted.a + m.transmitted.b,
          m.transmitted.a - m.transmitted.b};
}

// The root in double from the root in float: one Newton step.
inline LanesD refined_sqrt(const LanesD& x) {
  const Lanes rough = sqrt(math::convert<float>(x));
  const LanesD y = math::convert<double>(rough), half_over = math::convert<double>(Lanes(0.5f) / rough);
  return y + (x - y * y) * half_over;
}

// One event of a lossless film, ready for whichever model. L is float where no index depends on the wavelength.
template <class L, class D>
struct Crossing {
  D n1_squared, n2_squared, q1_squared, q2_squared, q2;
  const optics::FreeFilmIndices<L>& indices;
  LanesD cycles;  // equation (6)

  optics::FreeFilmAngle<L> angle() const {
    return {math::narrow(q1_squared), math::narrow(q2_squared), math::narrow(n1_squared - q1_squared)};
  }
};

inline Crossing<float, double> constant_crossing(const SceneTables& tables, const EventBlock& block, int lane,
                                                 const LanesD& thickness_per_wavelength) {
  const FilmTable& film = *block.film[lane];
  return {tables.medium_n_squared,
          film.n_squared,
          block.q1_squared[lane],
          block.q2_squared[lane],
          block.q2[lane],
          film.indices,
          thickness_per_wavelength * block.q2[lane]};
}

inline Crossing<Lanes, LanesD> dispersive_crossing(const SceneTables& tables, const EventBlock& block, int lane,
                                                   std::size_t comb, const LanesD& thickness_per_wavelength) {
  const FilmTable& film = *block.film[lane];
  const LanesD n1 = tables.combs[comb].medium_n_squared, n2 = film.n_squared_lanes[comb];
  const LanesD q1 = n1 * std::max(block.cos_i[lane] * block.cos_i[lane], optics::least_cos2), q2 = n2 - n1 + q1;
  const LanesD root = refined_sqrt(q2);
  return {n1, n2, q1, q2, root, film.indices_lanes[comb], thickness_per_wavelength * root};
}

template <class L, class D>
optics::WallReflectance<L> wall(const Crossing<L, D>& at) {
  using std::sqrt;
  return optics::wall_reflectance<L>(at.n1_squared, at.n2_squared, D(sqrt(at.q1_squared)), at.q2);
}

template <class L, class D>
inline Powers film_powers(optics::Interference mode, const Crossing<L, D>& at) {
  if (mode == optics::Interference::airy)
    return optics::free_film_powers(optics::free_film_factors(at.indices, at.angle()),
                                    optics::film_phase_sin2(at.cycles));
  if (mode == optics::Interference::two_beam)
    return wall_averages(optics::two_beam_powers(wall(at), optics::film_phase_sin2(at.cycles)));
  return optics::without_phase_powers<lane_count>(wall(at));
}

template <class L, class D>
inline Mueller film_mueller(optics::Interference mode, const Crossing<L, D>& at) {
  if (mode == optics::Interference::airy)
    return optics::free_film_mueller(optics::free_film_factors(at.indices, at.angle()),
                                     optics::free_film_turn(at.indices, at.angle()), optics::film_phase(at.cycles));
  using std::sqrt;
  const D q1(sqrt(at.q1_squared));
  const auto rho = wall(at);
  // r_s r_p of one wall with its sign, and t t' of both polarisations.
  const D signed_rho = (q1 - at.q2) * (at.n2_squared * q1 - at.n1_squared * at.q2) /
                       ((q1 + at.q2) * (at.n2_squared * q1 + at.n1_squared * at.q2));
  return without_phase_mueller(optics::without_phase_powers<lane_count>(rho), Lanes(math::narrow(signed_rho)),
                               Lanes(rho.pass_s) * Lanes(rho.pass_p));
}

// Stacks: several layers, absorbing ones, and layers of lower index than the medium (beyond their critical angle light
// tunnels through). Seen from the outside or the inside.
Powers stack_powers(const EventBlock& block, int lane, std::size_t comb);
Mueller stack_mueller(const EventBlock& block, int lane, std::size_t comb);

// One such layer under the models other than airy.
Mueller general_mueller(const SceneTables& tables, const FilmTable& film, std::size_t comb, double cos_i,
                        double thickness_nm);

// One event by the kind of its film: what `of_crossing` makes of a lossless one, `of_stack` computes for a stack,
// `of_mueller` makes of the blocks of any other.
template <class OfCrossing, class OfStack, class OfMueller>
inline auto film_at_event(const SceneTables& tables, const EventBlock& block, int lane, std::size_t comb,
                          const OfCrossing& of_crossing, const OfStack& of_stack, const OfMueller& of_mueller) {
  const FilmTable& film = *block.film[lane];
  const auto mode = tables.scene.render.interference;
  // The models other than airy have walls at any thickness; where there is no film there are none.
  if (mode != optics::Interference::airy && block.thickness_nm[lane] == 0) return of_mueller(grey_mueller(0));
  const LanesD per_wavelength = tables.combs[comb].inverse_wavelength_per_nm * block.thickness_nm[lane];
  switch (film.kind) {
    case FilmKind::constant:
      return of_crossing(mode, constant_crossing(tables, block, lane, per_wavelength));
    case FilmKind::dispersive:
      return of_crossing(mode, dispersive_crossing(tables, block, lane, comb, per_wavelength));
    case FilmKind::stack:
      return of_stack(block, lane, comb);
    case FilmKind::grey:
      return of_mueller(grey_mueller(tables.grey_reflectance));
    case FilmKind::general:
      break;
  }
  return of_mueller(general_mueller(tables, film, comb, block.cos_i[lane], block.thickness_nm[lane]));
}

// What the film does to a path whose events all lie in one plane.
inline Powers event_powers(const SceneTables& tables, const EventBlock& block, int lane, std::size_t comb) {
  return film_at_event(
      tables, block, lane, comb, [](auto mode, const auto& at) { return film_powers(mode, at); }, stack_powers,
      [](const Mueller& m) { return powers_of(m); });
}

// The same for any other path.
inline Mueller event_mueller(const SceneTables& tables, const EventBlock& block, int lane, std::size_t comb) {
  return film_at_event(
      tables, block, lane, comb, [](auto mode, const auto& at) { return film_mueller(mode, at); }, stack_mueller,
      [](const Mueller& m) { return m; });
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
