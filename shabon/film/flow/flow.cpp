#include "shabon/film/flow/flow.h"

#include <algorithm>
#include <cmath>

#include "shabon/film/flow/checkpoint.h"
#include "shabon/film/flow/exchange.h"
#include "shabon/film/flow/initial.h"
#include "shabon/film/flow/metric.h"
#include "shabon/film/flow/stepper.h"

namespace shabon::film {

struct FilmFlow::State {
  FlowDesc desc;
  Metric metric;
  Stepper stepper;
  FilmState film;
  std::vector<std::array<int, 3>> triangles;

  explicit State(const FlowDesc& chosen)
      : desc(chosen), metric(sphere_grid(chosen.level), chosen.radius_m), stepper(metric, desc) {
    const GridTopology& topology = metric.topology();
    triangles.reserve(static_cast<std::size_t>(topology.triangles));
    for (Index t = 0; t < topology.triangles; ++t) {
      const auto cells = topology.triangle_cells(t);
      triangles.push_back({static_cast<int>(cells[0]), static_cast<int>(cells[1]), static_cast<int>(cells[2])});
    }
  }
};

FilmFlow::FilmFlow(std::unique_ptr<State> state) : state_(std::move(state)) {}
FilmFlow::FilmFlow(FilmFlow&&) noexcept = default;
FilmFlow& FilmFlow::operator=(FilmFlow&&) noexcept = default;
FilmFlow::~FilmFlow() = default;

Result<FilmFlow> FilmFlow::start(const FlowDesc& desc, const InitialThickness& initial) {
  if (Diagnostics problems = check(desc); !problems.empty()) return problems;
  auto state = std::make_unique<State>(desc);
  auto film = initial_state(state->metric, desc, initial);
  if (!film) return film.errors();
  state->film = std::move(*film);
  return FilmFlow(std::move(state));
}

Result<FilmFlow> FilmFlow::resume(std::span<const std::byte> checkpoint) {
  auto read = read_checkpoint(checkpoint);
  if (!read) return read.errors();
  auto state = std::make_unique<State>(read->desc);
  state->film = std::move(read->film);
  return FilmFlow(std::move(state));
}

std::vector<std::byte> FilmFlow::checkpoint() const { return write_checkpoint(state_->desc, state_->film); }

Status FilmFlow::advance_to(double time_s, const StopFlag* stop) {
  FilmState& film = state_->film;
  if (!std::isfinite(time_s)) return fail(Failure::content, "the film cannot be advanced to a time that is no number");
  while (film.time_s < time_s && !film.rupture && !(stop != nullptr && stop->load())) {
    const double step_s = state_->stepper.step_towards(film, time_s);
    const bool last = step_s >= time_s - film.time_s;
    if (const Status done = state_->stepper.step(film, step_s, last ? time_s : film.time_s + step_s); !done)
      return done;
  }
  return Done{};
}

double FilmFlow::time_s() const { return state_->film.time_s; }
const FlowDesc& FilmFlow::desc() const { return state_->desc; }
std::optional<FilmFlow::Rupture> FilmFlow::rupture() const { return state_->film.rupture; }
std::span<const math::Vec3d> FilmFlow::directions() const { return state_->metric.grid->centres; }
std::span<const std::array<int, 3>> FilmFlow::triangles() const { return state_->triangles; }
std::span<const double> FilmFlow::areas_m2() const { return state_->metric.area.values(); }
std::span<const double> FilmFlow::thickness_m() const { return state_->film.thickness.values(); }
std::span<const double> FilmFlow::surfactant() const { return state_->film.surfactant.values(); }
std::vector<math::Vec3d> FilmFlow::velocity_m_s() const { return cell_vectors(state_->metric, state_->film.along); }
void FilmFlow::begin_report() { state_->film.frame = {}; }

FlowReport FilmFlow::report() const {
  const FilmState& film = state_->film;
  const auto h = film.thickness.values();
  const auto areas = areas_m2();
  FlowReport report = film.frame;
  report.time_s = film.time_s;
  report.film_m3 = integral(state_->metric, film.thickness);
  report.drop_m3 = film.drop_m3;
  report.evaporated_m3 = film.evaporated_m3;
  report.surfactant = integral(state_->metric, film.surfactant) / film.surfactant_at_start;
  const auto [thinnest, thickest] = std::minmax_element(h.begin(), h.end());
  double area = 0, black = 0;
  for (std::size_t c = 0; c < h.size(); ++c) {
    area += areas[c];
    if (state_->desc.black_film && is_black(*state_->desc.black_film, h[c])) black += areas[c];
  }
  report.thinnest_nm = *thinnest * 1e9;
  report.thickest_nm = *thickest * 1e9;
  report.mean_nm = report.film_m3 / area * 1e9;
  report.black_share = black / area;
  for (const double u : film.along.values()) report.fastest_m_s = std::max(report.fastest_m_s, std::abs(u));
  return report;
}

}  // namespace shabon::film
