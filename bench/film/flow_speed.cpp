#include "bench/film/flow_speed.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <ctime>

#include "shabon/film/flow/flow.h"

namespace shabon::bench {

namespace {

using film::FilmFlow;
using film::FlowDesc;
using film::FlowReport;

struct Case {
  const char* name;
  int level;
  bool wind;
  double film_s;  // that is timed, after as much again
  double goal;    // film time over processor time; 0 where none is set
};

constexpr Case cases[] = {{"level 4, still air", 4, false, 1, 0},        {"level 5, still air", 5, false, 1, 2},
                          {"level 5, wind of 1.6 m/s", 5, true, 0.4, 1}, {"level 6, still air", 6, false, 0.25, 0.3},
                          {"level 6, wind of 1.6 m/s", 6, true, 0.1, 0}, {"level 7, still air", 7, false, 0.02, 0},
                          {"level 8, still air", 8, false, 0.004, 0}};

// Huang, Iseringhausen, Kneiphof, Qu, Jiang and Hullin 2020, as they report it: on a GPU.
constexpr int finest_measured = 8;
constexpr double huang_points = 1024 * 2048, huang_step_s = 1.1, huang_film_s = 2e-3;

// What one step reads and writes for each cell, counted from the sweeps: in all, and for each iteration.
constexpr double bytes_a_step = 2700, bytes_an_iteration = 300;

// 5 cm, 1 um, 22 mN/m, 2e-5 m^2/s.
FlowDesc film_of(const Case& chosen) {
  FlowDesc desc;
  desc.level = chosen.level;
  desc.radius_m = 0.05;
  desc.mean_thickness_nm = 1000;
  desc.surface_viscosity_kg_s = 9.5e-9;
  if (chosen.wind) desc.air = {film::AirJet{.speed_m_s = 1.6, .envelope = {.ramp_s = 0.05}}};
  return desc;
}

double seconds_of(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Bytes a second, read and written, of copying as much as a film's state of that level.
double copy_rate(std::size_t cells) {
  constexpr std::size_t numbers_a_cell = 100;
  constexpr double bytes_in_all = 2e9;
  std::vector<double> from(cells * numbers_a_cell / 2, 1.0), to(from.size());
  const auto bytes = static_cast<double>(2 * from.size() * sizeof(double));
  const int rounds = static_cast<int>(bytes_in_all / bytes) + 1;
  double sum = 0;
  const double seconds = seconds_of([&] {
    for (int n = 0; n < rounds; ++n) {
      from[0] = n;
      std::memcpy(to.data(), from.data(), from.size() * sizeof(double));
      sum += to[static_cast<std::size_t>(n) % to.size()];
    }
  });
  return sum < 0 ? 0 : rounds * bytes / seconds;
}

struct Runs {
  std::vector<double> ms_a_step, iterations, speed, bandwidth, film_ms_a_step;
};

Status time_one(const Case& chosen, double film_s, double bytes_per_second, Runs& runs) {
  auto flow = FilmFlow::start(film_of(chosen));
  if (!flow) return flow.errors();
  if (const Status warm = flow->advance_to(film_s); !warm) return warm.errors();
  flow->begin_report();
  Status done = Done{};
  const double seconds = seconds_of([&] { done = flow->advance_to(2 * film_s); });
  if (!done) return done;
  const FlowReport report = flow->report();
  const double iterations = static_cast<double>(report.iterations) / report.steps;
  const auto cells = static_cast<double>(flow->thickness_m().size());
  runs.ms_a_step.push_back(1e3 * seconds / report.steps);
  runs.iterations.push_back(iterations);
  runs.speed.push_back(film_s / seconds);
  runs.film_ms_a_step.push_back(1e3 * film_s / report.steps);
  const double bytes = cells * (bytes_a_step + bytes_an_iteration * iterations) * report.steps;
  runs.bandwidth.push_back(bytes / seconds / bytes_per_second);
  return Done{};
}

// One row beside another solver: how long a step takes and how far it goes.
std::vector<std::string> step_row(const std::string& name, double cells, double step_s, double film_s) {
  return {name,
          fmt::format("{:.0f}", cells),
          fmt::format("{:.2f}", 1e3 * film_s),
          fmt::format("{:.4g}", 1e3 * step_s),
          fmt::format("{:.2f}", 1e6 * step_s / cells),
          fmt::format("{:.3g}", step_s / film_s)};
}

}  // namespace

Status bench_flow(Report& report, int repetitions, bool quick) {
  report.heading("The simulated film");
  report.paragraph(
      "A film of 5 cm radius, 1 um, 22 mN/m, 2e-5 m^2/s on one core: milliseconds of processor time per step, "
      "iterations\n"
      "of the elastic step, film time over processor time, and the bytes that a step reads and writes over those of\n"
      "copying memory of the same size.");
  Table table({"film", "ms a step", "iterations", "film time over processor time", "share of bandwidth", "goal"});
  Table beside({"solver", "cells", "film ms a step", "ms a step", "us a cell and step", "times slower than the film"});
  beside.add(step_row("Huang et al. 2020, on a GPU", huang_points, huang_step_s, huang_film_s));
  for (const Case& chosen : cases) {
    Runs runs;
    const std::size_t cells = std::size_t{10} << (2 * chosen.level);
    const double rate = copy_rate(cells);
    for (int n = 0; n < repetitions; ++n)
      if (const Status done = time_one(chosen, quick ? chosen.film_s / 10 : chosen.film_s, rate, runs); !done)
        return done;
    const Spread ms = spread_of(runs.ms_a_step), speed = spread_of(runs.speed), share = spread_of(runs.bandwidth);
    const Spread iterations = spread_of(runs.iterations);
    report.record("film", fmt::format("{}, step", chosen.name), "ms", ms);
    report.record("film", fmt::format("{}, iterations", chosen.name), "per step", iterations);
    report.record("film", fmt::format("{}, speed", chosen.name), "film s per processor s", speed);
    report.record("film", fmt::format("{}, bandwidth", chosen.name), "of copying", share);
    table.add({chosen.name, shown(ms, 2), shown(iterations, 1), shown(speed, 2), shown(share, 2),
               chosen.goal > 0 ? verdict(speed.median >= chosen.goal, fmt::format("at least {}", chosen.goal)) : ""});
    const double cells_here = static_cast<double>(cells) + 2, film_s = spread_of(runs.film_ms_a_step).median / 1e3;
    if (chosen.wind || chosen.level < 5) continue;
    beside.add(step_row(chosen.name, cells_here, ms.median / 1e3, film_s));
    if (chosen.level < finest_measured) continue;
    const double more = huang_points / cells_here;
    beside.add(step_row("the same with as many cells (computed)", huang_points, ms.median / 1e3 * more,
                        film_s / std::sqrt(more)));
  }
  report.table(table);
  report.paragraph(
      "Beside the solver that is known best, which reports about 1.1 s for a step of 2 ms at 1024 x 2048 points. The\n"
      "last row scales the finest film to as many cells: the cost of a cell as it is, steps as much shorter as cells "
      "are.");
  report.table(beside);
  return Done{};
}

}  // namespace shabon::bench
