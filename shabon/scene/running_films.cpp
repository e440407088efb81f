#include "shabon/scene/running_films.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "shabon/film/flow/dryness.h"
#include "shabon/scene/bubble_motion.h"

namespace shabon::scene {

namespace {

// Nodes along the edge of a cube face: six for each cell of the grid, so that the map keeps what the grid resolves.
int map_size_of(int level) { return 6 << std::min(level, 7); }

// A film stops at every multiple of this, and goes on from there after a look in between, so that its steps do not
// depend on who looks on.
constexpr double pause_s = 0.04;
constexpr double same_moment_s = 1e-9;

}  // namespace

Result<RunningFilms> RunningFilms::start(const Scene& scene) {
  RunningFilms running;
  for (const Film& film : scene.films) {
    if (!film.flow) continue;
    auto flow = film::FilmFlow::start(*film.flow);
    if (!flow) return flow.errors();
    const int size = map_size_of(film.flow->level);
    film::FlowBake bake(*flow, film::node_directions(size));
    running.films_.push_back({std::move(flow).value(), std::move(bake), size, {}, false});
  }
  return running;
}

Status RunningFilms::advance_to(double time_s, const StopFlag* stop, const ProgressReport& progress) {
  for (std::size_t i = 0; i < films_.size(); ++i) {
    const double from_s = films_[i].flow.time_s();
    if (!(from_s < time_s - same_moment_s)) continue;
    if (const Status back = return_to_pause(films_[i]); !back) return back;
    film::FilmFlow& flow = films_[i].flow;
    while (flow.time_s() < time_s - same_moment_s && !flow.rupture()) {
      const double next_s = (std::floor(flow.time_s() / pause_s * (1 + 1e-12)) + 1) * pause_s;
      const bool aside = next_s > time_s + same_moment_s;
      if (aside) films_[i].pause = flow.checkpoint();
      if (const Status done = flow.advance_to(aside ? time_s : next_s, stop); !done) return done;
      if (stop != nullptr && *stop) return Done{};
      if (!films_[i].told_dry) tell_dry(i, film::why_dry(flow), news_);
      const double share = std::min(1.0, (flow.time_s() - from_s) / (time_s - from_s));
      if (progress) progress((static_cast<double>(i) + share) / static_cast<double>(films_.size()));
    }
  }
  return Done{};
}

Status RunningFilms::return_to_pause(Running& running) {
  if (running.pause.empty()) return Done{};
  auto flow = film::FilmFlow::resume(running.pause);
  if (!flow) return flow.errors();
  running.flow = std::move(flow).value();
  running.pause.clear();
  return Done{};
}

namespace {

// Of a film that breaks by itself the hole opens where and when it did.
void burst(Film& film, const std::optional<film::FilmFlow::Rupture>& rupture, double time_s) {
  if (!film.bursting || (film.bursting->by_itself && !rupture)) return;
  auto [body, popping, by_itself] = *film.bursting;
  if (by_itself) popping.from_centre = rupture->from_centre, popping.start_s = rupture->time_s;
  if (time_s <= popping.start_s) return;
  if (body.thickness_m == 0) body.thickness_m = film::mean_thickness_nm(film.thickness) * 1e-9;
  open_hole(film, film::hole_at(body, popping, time_s), body, popping.from_centre);
}

}  // namespace

void RunningFilms::show_in(Scene& scene) const {
  std::size_t next = 0;
  for (Film& film : scene.films) {
    if (!film.flow || next == films_.size()) continue;
    const Running& running = films_[next++];
    auto map = std::make_shared<film::SphereMap>();
    map->size = running.map_size;
    map->nm.resize(running.bake.size());
    running.bake.thickness_nm(running.flow, map->nm);
    film.thickness = std::shared_ptr<const film::SphereMap>(std::move(map));
    burst(film, running.flow.rupture(), scene.time_s);
  }
  add_rims(scene);
}

Status run_films(Scene& scene, const StopFlag* stop, const ProgressReport& progress) {
  auto films = RunningFilms::start(scene);
  if (!films) return films.errors();
  if (const Status done = films->advance_to(scene.time_s, stop, progress); !done) return done;
  films->show_in(scene);
  return Done{};
}

std::optional<film::FilmFlow::Rupture> RunningFilms::rupture() const {
  std::optional<film::FilmFlow::Rupture> first;
  for (const Running& running : films_)
    if (const auto broken = running.flow.rupture(); broken && (!first || broken->time_s < first->time_s))
      first = broken;
  return first;
}

void RunningFilms::tell_dry(std::size_t film, const std::optional<std::string>& why, Diagnostics& told) {
  if (!why) return;
  Diagnostic& warning = told.emplace_back();
  warning.severity = Severity::warning;
  warning.message = (films_.size() > 1 ? "simulated film " + std::to_string(film + 1) + ": " : "") + *why;
  films_[film].told_dry = true;
}

Diagnostics RunningFilms::forecast(double until_s) {
  Diagnostics told;
  for (std::size_t i = 0; i < films_.size(); ++i)
    if (!films_[i].told_dry) tell_dry(i, film::why_dry_before(films_[i].flow.desc(), until_s), told);
  return told;
}

Diagnostics RunningFilms::news() { return std::exchange(news_, {}); }

}  // namespace shabon::scene
