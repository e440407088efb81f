#include "shabon/render/kernel/film_optics.h"

#include "shabon/optics/reference/mueller.h"

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

// One block of the reference, lane by lane.
class BlockOfRows {
 public:
  void set(int lane, const optics::MuellerRow& row) {
    const double values[] = {row.a, row.b, row.c, row.d};
    for (int k = 0; k < 4; ++k) values_[k][lane] = static_cast<float>(values[k]);
  }
  optics::MuellerBlock<lane_count> block() const {
    return {Lanes::load(values_[0]), Lanes::load(values_[1]), Lanes::load(values_[2]), Lanes::load(values_[3])};
  }

 private:
  alignas(64) float values_[4][lane_count];
};

// The models other than airy.
Mueller from_reference(const SceneTables& tables, const FilmTable& film, std::size_t comb, double cos_i,
                       double thickness_nm) {
  const double cos2 = std::max(cos_i * cos_i, optics::least_cos2);
  const optics::Incidence incidence = optics::incidence_from_cos(std::sqrt(cos2));
  BlockOfRows reflected, transmitted;
  for (int i = 0; i < lane_count; ++i) {
    const double n1 = std::sqrt(tables.combs[comb].medium_n_squared[i]);
    const std::complex<double> n2(film.n_lanes[comb][0][i], film.n_lanes[comb][1][i]);
    const double wavelength_nm = 1 / tables.combs[comb].inverse_wavelength_per_nm[i];
    const optics::FilmRows rows =
        optics::film_rows(tables.scene.render.interference, n1, n2, n1, thickness_nm, incidence, wavelength_nm);
    reflected.set(i, rows.reflected);
    transmitted.set(i, rows.transmitted);
  }
  return {reflected.block(), transmitted.block()};
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
