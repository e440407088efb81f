#include "bench/render/speed.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "bench/scenes.h"
#include "shabon/base/parallel.h"
#include "shabon/optics/media.h"
#include "shabon/render/render.h"

namespace shabon::bench {

namespace {

constexpr double grey_reflectance = 0.08;
constexpr double least_samples_per_second = 12e6, least_scaling = 0.9, most_built_in_seconds = 5;

using Counter = std::uint64_t render::RenderReport::*;

struct Run {
  render::RenderReport report;
  double processor_seconds;  // of all threads together
  double count(Counter counter) const { return static_cast<double>(report.*counter); }
};

// One thing that is rendered again and again.
struct Job {
  std::string name;
  const scene::Scene* scene;
  int threads = 1;
  std::optional<double> grey;
  std::vector<Run> runs;

  void run(int samples) {
    scene::Scene now = *scene;
    now.render.samples = samples;
    render::RenderOptions options;
    options.threads = threads;
    options.grey_reflectance = grey;
    render::Sensor sensor(now.width, now.height);
    const std::clock_t start = std::clock();
    if (const auto done = render::render(now, options, sensor))
      runs.push_back({*done, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC});
  }

  template <class Value>
  Spread spread(const Value& value) const {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return spread_of(std::move(values));
  }
  Spread rate(Counter counter, double scale = 1) const {
    return spread([&](const Run& run) { return scale * run.count(counter) / run.report.seconds; });
  }
  Spread rate_of_core(Counter counter, double scale = 1) const {
    return spread([&](const Run& run) { return scale * run.count(counter) / run.processor_seconds; });
  }
  // Of processor time: other work on the machine disturbs it less.
  Spread nanoseconds_per(Counter counter) const {
    return spread([&](const Run& run) { return 1e9 * run.processor_seconds / run.count(counter); });
  }
};

// The measure of what two threads can give on this machine: cosines, shared out like the tiles of a picture.
double cosine_seconds(int threads) {
  constexpr std::size_t pieces = 7500;  // as many as 800 x 600 pixels have tiles
  constexpr int cosines = 4000;
  std::vector<double> sums(pieces);
  const auto start = std::chrono::steady_clock::now();
  parallel_for(pieces, threads, [&](std::size_t piece) {
    double sum = 0;
    for (int i = 0; i < cosines; ++i) sum += std::cos(static_cast<double>(piece) + 0.01 * i);
    sums[piece] = sum;
  });
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Measurements {
  std::vector<Job> jobs;
  std::vector<double> cosines[2];  // seconds with 1 and 2 threads

  void repeat(int repetitions, int samples) {
    for (Job& job : jobs) job.run(1);  // warms up
    for (Job& job : jobs) job.runs.clear();
    for (int i = 0; i < repetitions; ++i) {
      std::fprintf(stderr, "\rbench: rendering, round %d of %d ", i + 1, repetitions);
      // Each one-thread run stands beside its two-thread run, and so do the cosines.
      for (Job& job : jobs) job.run(samples);
      for (const int threads : {1, 2}) cosines[threads - 1].push_back(cosine_seconds(threads));
    }
    std::fputc('\n', stderr);
  }
};

enum Which { built_in_1, built_in_2, windows_1, windows_2, empty_1, grey_1, two_beam_1, water_1 };

void report_rates(Report& report, const Measurements& all, int samples) {
  using render::RenderReport;
  report.heading("The whole renderer");
  report.paragraph(fmt::format(
      "800 x 600 pixels, {} samples a pixel, {} rounds in turn. Millions per second, the figures a core by processor\n"
      "time; rays are straight segments whose next wall is looked for, film events are meetings with a film.\n"
      "`Built-in` has a dispersive film (water) under softboxes; `windows` has n = 1.333 under a picture.",
      samples, all.cosines[0].size()));
  Table table({"bubble", "threads", "camera samples", "camera samples a core", "rays a core", "film events a core"});
  for (const Which which : {built_in_1, built_in_2, windows_1, windows_2}) {
    const Job& job = all.jobs[which];
    const auto core = [&](Counter counter, const char* what) {
      report.record("render", fmt::format("{}, {} threads, {}", job.name, job.threads, what), "per second and core",
                    job.rate_of_core(counter));
      return shown(job.rate_of_core(counter, 1e-6), 1);
    };
    report.record("render", fmt::format("{}, {} threads, camera samples", job.name, job.threads), "per second",
                  job.rate(&RenderReport::camera_samples));
    table.add({job.name, std::to_string(job.threads), shown(job.rate(&RenderReport::camera_samples, 1e-6), 1),
               core(&RenderReport::camera_samples, "camera samples"), core(&RenderReport::rays, "rays"),
               core(&RenderReport::film_events, "film events")});
  }
  report.table(table);
  const double rate = all.jobs[windows_2].rate(&RenderReport::camera_samples).median;
  report.paragraph(
      verdict(rate >= least_samples_per_second, "Goal of 12 million camera samples a second on 2 threads (windows)") +
      fmt::format(" ({:.1f}).", rate * 1e-6));
}

// Whether the clock can be trusted: on a quiet machine a single thread has a whole core.
void report_quiet(Report& report, const Measurements& all) {
  constexpr double least_share = 0.95;
  std::vector<double> shares;
  for (const Job& job : all.jobs)
    for (const Run& run : job.runs)
      if (job.threads == 1) shares.push_back(100 * run.processor_seconds / run.report.seconds);
  const Spread share = spread_of(std::move(shares));
  report.record("render", "share of a core that a thread had", "percent", share);
  report.paragraph(fmt::format("In these rounds a single thread had {} % of a core.{}", shown(share, 0),
                               share.median >= 100 * least_share
                                   ? ""
                                   : " The machine did other work: trust what is by processor time, not the clock."));
}

void report_events(Report& report, const Measurements& all) {
  using render::RenderReport;
  report.heading("The price of interference");
  report.paragraph(fmt::format(
      "Nanoseconds of processor time per film event of the running renderer on one thread, bubble under the windows.\n"
      "`All in` shares the whole time among the film events: camera rays, geometry, optics, surroundings, adding up.\n"
      "`Beyond empty` leaves out what the same picture takes without a bubble, because films that reflect more have "
      "more\n"
      "events to each camera ray. The grey film reflects {} at every wavelength: what a film costs more than it is "
      "the\n"
      "price of interference.",
      grey_reflectance));
  const double empty = all.jobs[empty_1].nanoseconds_per(&RenderReport::camera_samples).median;
  const std::pair<Which, const char*> films[] = {
      {grey_1, "grey"}, {two_beam_1, "two-beam, n = 1.333"}, {windows_1, "Airy, n = 1.333"}, {water_1, "Airy, water"}};
  Table table({"film", "events a camera sample", "all in", "more than grey", "beyond empty", "more than grey"});
  double grey[2] = {};
  for (const auto& film : films) {
    const Which which = film.first;
    const char* name = film.second;
    const Job& job = all.jobs[which];
    const Run& first = job.runs.front();
    const double events = first.count(&RenderReport::film_events) / first.count(&RenderReport::camera_samples);
    const Spread whole = job.nanoseconds_per(&RenderReport::film_events);
    const double net = whole.median - empty / events;
    if (which == grey_1) grey[0] = whole.median, grey[1] = net;
    const auto more = [&](double value, double than) {
      return which == grey_1 ? "" : fmt::format("{:+.1f} ({:.2f} times)", value - than, value / than);
    };
    report.record("render", fmt::format("windows, {}", name), "ns per film event, all in", whole);
    report.record("render", fmt::format("windows, {}", name), "ns per film event, beyond empty", {net, net, net, 1});
    table.add({name, fmt::format("{:.2f}", events), shown(whole, 1), more(whole.median, grey[0]),
               fmt::format("{:.1f}", net), more(net, grey[1])});
  }
  report.table(table);
}

void report_scaling(Report& report, const Measurements& all) {
  report.heading("From one thread to two");
  report.paragraph("Time with 1 thread over time with 2, round by round: the renderer against a loop of std::cos.");
  Table table({"work", "speed-up", "share of the loop's"});
  const auto scaling = [&](std::size_t round, Which one, Which two) {
    return all.jobs[one].runs[round].report.seconds / all.jobs[two].runs[round].report.seconds;
  };
  std::vector<double> loop;
  for (std::size_t i = 0; i < all.cosines[0].size(); ++i) loop.push_back(all.cosines[0][i] / all.cosines[1][i]);
  report.record("scaling", "std::cos", "ratio", spread_of(loop));
  table.add({"std::cos", shown(spread_of(loop), 2), ""});
  double share_of_windows = 0;
  for (const auto& [one, two] : {std::pair(built_in_1, built_in_2), std::pair(windows_1, windows_2)}) {
    std::vector<double> own, share;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      own.push_back(scaling(i, one, two));
      share.push_back(own.back() / loop[i]);
    }
    const std::string& name = all.jobs[one].name;
    report.record("scaling", name, "ratio", spread_of(own));
    report.record("scaling", name + " over std::cos", "ratio", spread_of(share));
    table.add({name, shown(spread_of(own), 2), shown(spread_of(share), 2)});
    share_of_windows = spread_of(share).median;
  }
  report.table(table);
  report.paragraph(verdict(share_of_windows >= least_scaling, "Goal of 0.9 of the loop's speed-up (windows)") +
                   fmt::format(" ({:.2f}).", share_of_windows));
}

// The picture that `./dev demo` makes.
void report_built_in(Report& report, const scene::Scene& scene, int repetitions) {
  Job job{"built-in picture", &scene, 2, {}, {}};
  for (int i = 0; i < repetitions; ++i) job.run(scene.render.samples);
  const Spread seconds = job.spread([](const Run& run) { return run.report.seconds; });
  report.record("render", job.name, "seconds", seconds);
  report.paragraph(fmt::format("The built-in bubble with its {} samples a pixel on 2 threads: {} s. {}.",
                               scene.render.samples, shown(seconds, 2),
                               verdict(seconds.median < most_built_in_seconds, "Goal of 5 s")));
}

}  // namespace

Status bench_speed(Report& report, int repetitions, int samples) {
  const auto built_in = built_in_bubble(), windows = windows_bubble();
  if (!built_in) return built_in.errors();
  if (!windows) return windows.errors();
  scene::Scene empty = *windows, two_beam = *windows, water = *windows;
  empty.spheres.clear();
  two_beam.render.interference = optics::Interference::two_beam;
  const auto medium = optics::find_medium("water");
  if (!medium) return fail(Failure::internal, "no medium 'water'");
  water.films.front().layers.front().medium = *medium;

  Measurements all;
  all.jobs = {{"built-in", &*built_in, 1, {}, {}},         {"built-in", &*built_in, 2, {}, {}},
              {"windows", &*windows, 1, {}, {}},           {"windows", &*windows, 2, {}, {}},
              {"windows, no bubble", &empty, 1, {}, {}},   {"windows, grey", &*windows, 1, grey_reflectance, {}},
              {"windows, two-beam", &two_beam, 1, {}, {}}, {"windows, water", &water, 1, {}, {}}};
  all.repeat(repetitions, samples);
  report_rates(report, all, samples);
  report_quiet(report, all);
  report_built_in(report, *built_in, std::max(1, repetitions / 2));
  report_events(report, all);
  report_scaling(report, all);
  return Done{};
}

}  // namespace shabon::bench
