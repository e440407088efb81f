#include "shabon/render/kernel/film_optics.h"

#include "shabon/optics/reference/no_interference.h"
#include "shabon/optics/reference/two_beam.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

using Complex = math::complex_packet<double, lane_count>;

optics::MuellerBlock<lane_count> block(const Complex& x_s, const Complex& x_p, const LanesD& factor_s,
                                       const LanesD& factor_p) {
  const LanesD s = norm(x_s) * factor_s, p = norm(x_p) * factor_p;
  // Equal media on both sides: the two factors are equal, and their root mean is either of them.
  const Complex both = x_s * conj(x_p) * Complex(factor_s);
  const auto to_float = [](const LanesD& value) { return math::convert<float>(value); };
  return {to_float((s + p) * 0.5), to_float((s - p) * 0.5), to_float(both.re), to_float(both.im)};
}

// The models without phases between s and p: lane by lane from the reference. Their light keeps what linear
// polarisation the powers leave; the sign of c is that of the first wall.
Mueller from_reference(const SceneTables& tables, const FilmTable& film, std::size_t comb, double cos_i,
                       double thickness_nm) {
  const optics::Incidence incidence = optics::incidence_from_cos(cos_i);
  const bool paper = tables.scene.render.interference == optics::Interference::two_beam;
  float R_s[lane_count], R_p[lane_count], T_s[lane_count], T_p[lane_count];
  for (int i = 0; i < lane_count; ++i) {
    const double n1 = std::sqrt(tables.combs[comb].medium_n_squared[i]);
    const std::complex<double> n2(film.n_lanes[comb][0][i], film.n_lanes[comb][1][i]);
    const double wavelength_nm = 1 / tables.combs[comb].inverse_wavelength_per_nm[i];
    const optics::Powers p = paper ? optics::two_beam(n1, n2, n1, thickness_nm, incidence, wavelength_nm)
                                   : optics::without_interference(n1, n2, n1, thickness_nm, incidence, wavelength_nm);
    R_s[i] = static_cast<float>(p.R_s), R_p[i] = static_cast<float>(p.R_p);
    T_s[i] = static_cast<float>(p.T_s), T_p[i] = static_cast<float>(p.T_p);
  }
  Powers p{Lanes::load(R_s), Lanes::load(R_p), Lanes::load(T_s), Lanes::load(T_p)};
  if (paper) p = wall_averages(p);
  const Lanes half(0.5f), zero(0.0f);
  return {{half * (p.R_s + p.R_p), half * (p.R_s - p.R_p), -sqrt(p.R_s * p.R_p), zero},
          {half * (p.T_s + p.T_p), half * (p.T_s - p.T_p), sqrt(p.T_s * p.T_p), zero}};
}

}  // namespace

Mueller general_mueller(const SceneTables& tables, const FilmTable& film, std::size_t comb, double cos_i,
                        double thickness_nm) {
  if (tables.scene.render.interference != optics::Interference::airy)
    return from_reference(tables, film, comb, cos_i, thickness_nm);
  const double cos2 = std::max(cos_i * cos_i, optics::least_cos2);
  const LanesD n1 = sqrt(tables.combs[comb].medium_n_squared);
  const optics::LayerLanes<lane_count> at{Complex(n1), Complex(film.n_lanes[comb][0], film.n_lanes[comb][1]),
                                          Complex(n1), tables.combs[comb].inverse_wavelength_per_nm};
  const auto x = optics::airy_amplitudes(at, thickness_nm, std::sqrt(cos2));
  const LanesD one(1.0);
  return {block(x.r_s, x.r_p, one, one), block(x.t_s, x.t_p, x.transmission_s, x.transmission_p)};
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
