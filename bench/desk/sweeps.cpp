#include "bench/desk/sweeps.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/micro.h"
#include "shabon/desk/sweep.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::bench {

namespace {

constexpr double seconds_each = 0.05;
constexpr double goal_ms = 50;             // of a Newton chart on one core
constexpr int newton_films = 1501;         // 0..1500 nm
constexpr int reference_step = 50;         // the reference computes every 50th of them
constexpr double most_difference = 1e-11;  // of the sum of all Y
constexpr double ns_per_ms = 1e6;

struct Series {
  const char *name, *stack;
  std::size_t layer;
  double incidence_deg;
};

constexpr Series all_series[] = {
    {"free film", "air | water 0nm | air", 0, 0},
    {"free film", "air | water 0nm | air", 0, 45},
    {"oxide on titanium", "air | TiO2 0nm | Ti", 0, 45},
    {"spacer between ten layers and silver", "air | (ZnS 58nm | MgF2 99nm)^5 | SiO2 0nm | Ag 40nm | glass", 10, 45},
};

Result<desk::Sweep> sweep_of(const Series& series, int step) {
  const auto stack = optics::parse_stack(series.stack);
  if (!stack) return stack.errors();
  desk::Sweep sweep{*stack, series.layer, {}, optics::incidence_from(Degrees(series.incidence_deg))};
  for (int i = 0; i < newton_films; i += step) sweep.thicknesses_nm.push_back(i);
  return sweep;
}

double swept(const desk::Sweep& sweep) {
  double sum = 0;
  const auto colours = desk::swept_colors(sweep, color::illuminants().front());
  if (!colours) return std::nan("");
  for (const color::Xyz& colour : *colours) sum += colour.y;
  return sum;
}

// Every wavelength of every thickness anew.
double one_by_one(desk::Sweep sweep) {
  double sum = 0;
  for (const double thickness_nm : sweep.thicknesses_nm) {
    sweep.stack.layers[sweep.layer].thickness_nm = thickness_nm;
    const color::Spectrum share = desk::unpolarised(sweep.stack, sweep.interference, sweep.incidence, sweep.side);
    sum += color::reflectance_to_xyz(share, color::illuminants().front()).y;
  }
  return sum;
}

}  // namespace

Status bench_sweeps(Report& report, int repetitions) {
  std::vector<Micro> loops;
  for (const Series& series : all_series) {
    const auto all = sweep_of(series, 1), some = sweep_of(series, reference_step);
    if (!all) return all.errors();
    if (const double got = swept(*some), expected = one_by_one(*some); !(std::abs(got - expected) < most_difference))
      return fail(Failure::internal, fmt::format("{}: expected the sum {}, got {}", series.stack, expected, got));
    const std::string name = fmt::format("{} at {} degrees", series.name, series.incidence_deg);
    const double share = static_cast<double>(some->thicknesses_nm.size()) / newton_films;
    loops.push_back({name + ", swept", [sweep = *all] { return swept(sweep); }, ns_per_ms});
    loops.push_back({name + ", one by one", [sweep = *some] { return one_by_one(sweep); }, ns_per_ms * share});
  }
  const std::vector<Spread> times = nanoseconds_per_item(loops, repetitions, seconds_each);

  report.heading("Newton's colours");
  report.paragraph(
      fmt::format("The colours of {} thicknesses from spectra at {} wavelengths, 1 nm apart; milliseconds "
                  "on one core, with all preparation. 'One by one' is the reference.",
                  newton_films, color::spectrum_size));
  Table table({"stack", "degrees", "swept, ms", "one by one, ms", "ratio"});
  bool reached = true;
  for (std::size_t i = 0; i < std::size(all_series); ++i) {
    const Spread &fast = times[2 * i], &slow = times[2 * i + 1];
    table.add({all_series[i].name, fmt::format("{}", all_series[i].incidence_deg), shown(fast, 2), shown(slow, 0),
               fmt::format("{:.0f}", slow.median / fast.median)});
    reached = reached && fast.median < goal_ms;
    report.record("desk", loops[2 * i].name, "ms per chart", fast);
    report.record("desk", loops[2 * i + 1].name, "ms per chart", slow);
  }
  report.table(table);
  report.paragraph("Goal " + verdict(reached, fmt::format("below {} ms", goal_ms)) + ".");
  return Done{};
}

}  // namespace shabon::bench
