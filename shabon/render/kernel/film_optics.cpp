#include "shabon/render/kernel/film_optics.h"

#include "shabon/optics/reference/mueller.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

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

}  // namespace

Mueller general_mueller(const SceneTables& tables, const FilmTable& film, std::size_t comb, double cos_i,
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

namespace {

optics::StackRay ray_of(const EventBlock& block, int lane) {
  return {.cos_i = block.cos_i[lane],
          .from_exit = !block.inward[lane],
          .layer = block.film[lane]->varied_layer,
          .thickness_nm = block.thickness_nm[lane]};
}

}  // namespace

Powers stack_powers(const EventBlock& block, int lane, std::size_t comb) {
  return optics::stack_powers<lane_count>(*block.film[lane]->stack, comb * lane_count, ray_of(block, lane));
}

Mueller stack_mueller(const EventBlock& block, int lane, std::size_t comb) {
  return optics::stack_mueller<lane_count>(*block.film[lane]->stack, comb * lane_count, ray_of(block, lane));
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
