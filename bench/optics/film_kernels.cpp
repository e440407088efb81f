#include "bench/optics/film_kernels.h"

#include "shabon/render/kernel/film_optics.h"

namespace shabon::bench {

using render::Lanes;

struct FilmPackets::Tables {
  explicit Tables(const scene::Scene& scene) : of(scene, std::nullopt) {}
  render::SceneTables of;
};

namespace {

static_assert(block_size == render::ray_block);
constexpr auto blocks = event_count / block_size;

// As event_geometry() leaves it, with the angles in the medium and in the film.
void prepare(const render::SceneTables& tables, const FilmEvents& events, int number, render::EventBlock& block) {
  using render::Rays;
  const auto first = static_cast<std::size_t>(number * block_size);
  const Rays cos_i = Rays::load(&events.cos_i[first]), n1_squared(tables.medium_n_squared);
  const Rays q1_squared = n1_squared * max(cos_i * cos_i, Rays(optics::least_cos2));
  const Rays q2_squared = Rays(block.film[0]->n_squared) - n1_squared + q1_squared;
  cos_i.store(block.cos_i), Rays::load(&events.thickness_nm[first]).store(block.thickness_nm);
  q1_squared.store(block.q1_squared), q2_squared.store(block.q2_squared);
  sqrt(max(q2_squared, Rays(0.0))).store(block.q2);
}

render::EventBlock block_of(const render::SceneTables& tables) {
  render::EventBlock block{};
  for (int lane = 0; lane < block_size; ++lane) {
    block.film[lane] = &tables.films.front();
    block.cos_2phi[lane] = 0.8f, block.sin_2phi[lane] = 0.6f;
  }
  return block;
}

// Keeps a packet that nobody reads from being left out.
void keep(const Lanes& lanes) { asm volatile("" : : "m"(lanes)); }

double mean(const Lanes& sum) { return math::sum(math::convert<double>(sum)) / (event_count * double(Lanes::size)); }

}  // namespace

FilmPackets::FilmPackets(const scene::Scene& scene) : tables_(std::make_unique<Tables>(scene)) {}
FilmPackets::~FilmPackets() = default;

double FilmPackets::powers(const FilmEvents& events) const {
  const render::SceneTables& tables = tables_->of;
  render::EventBlock block = block_of(tables);
  Lanes reflected(0.0f), transmitted(0.0f);
  for (int number = 0; number < blocks; ++number) {
    prepare(tables, events, number, block);
    for (int lane = 0; lane < block_size; ++lane) {
      const render::Powers film = render::event_powers(tables, block, lane, comb_of_block(number));
      reflected += (film.R_s + film.R_p) * 0.5f;
      transmitted += film.T_s + film.T_p;
    }
  }
  keep(transmitted);
  return mean(reflected);
}

double FilmPackets::stokes_rows(const FilmEvents& events) const {
  const render::SceneTables& tables = tables_->of;
  render::EventBlock block = block_of(tables);
  Lanes reflected(0.0f);
  render::Row sum{Lanes(0.0f), Lanes(0.0f), Lanes(0.0f), Lanes(0.0f)};
  const auto add = [&](const render::Row& row) {
    sum = {sum.q0 + row.q0, sum.q1 + row.q1, sum.q2 + row.q2, sum.q3 + row.q3};
  };
  const render::Row row{Lanes(1.0f), Lanes(0.4f), Lanes(0.3f), Lanes(0.2f)};
  for (int number = 0; number < blocks; ++number) {
    prepare(tables, events, number, block);
    for (int lane = 0; lane < block_size; ++lane) {
      const render::Mueller film = render::event_mueller(tables, block, lane, comb_of_block(number));
      const render::Row in_plane = optics::rotated(row, block.cos_2phi[lane], block.sin_2phi[lane]);
      add(optics::through(in_plane, film.reflected)), add(optics::through(in_plane, film.transmitted));
      reflected += film.reflected.a;
    }
  }
  keep(sum.q0), keep(sum.q1), keep(sum.q2), keep(sum.q3);
  return mean(reflected);
}

}  // namespace shabon::bench
