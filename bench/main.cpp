// shabon_bench: all benchmarks in one run, as a report in Markdown on standard output.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>

#include "bench/desk/sweeps.h"
#include "bench/film/flow_speed.h"
#include "bench/geometry/next_shape.h"
#include "bench/geometry/next_wall.h"
#include "bench/machine.h"
#include "bench/optics/films.h"
#include "bench/optics/stacks.h"
#include "bench/render/noise.h"
#include "bench/render/shares.h"
#include "bench/render/speed.h"
#include "bench/render/transports.h"
#include "shabon/io/file.h"

namespace {

using namespace shabon;

struct Options {
  bool quick = false;
  std::vector<std::string> only;
  std::string json, update;
  bool wants(const std::string& name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
};

Status run(const Options& options, bench::Report& report) {
  constexpr int repetitions = 9, quick_repetitions = 3;
  constexpr int rounds = 5, quick_rounds = 2;
  constexpr int samples = 16, quick_samples = 4;
  for (const std::string& file : {options.json, options.update})
    if (!file.empty())
      if (const Status writable = io::check_writable(file); !writable) return writable;
  const int repeat = options.quick ? quick_repetitions : repetitions;
  report.paragraph(bench::machine_line() + "\nMedian (least..most)." +
                   (options.quick ? " A quick run: not for comparing." : ""));
  Status done = Done{};
  if (options.wants("optics")) done = bench::bench_films(report, repeat);
  if (done && options.wants("optics")) done = bench::bench_stacks(report, repeat);
  if (done && options.wants("desk")) done = bench::bench_sweeps(report, repeat);
  if (done && options.wants("render"))
    done = bench::bench_speed(report, options.quick ? quick_rounds : rounds, options.quick ? quick_samples : samples);
  if (done && options.wants("noise")) done = bench::bench_noise(report, !options.quick);
  if (done && options.wants("transports")) done = bench::bench_transports(report, options.quick ? 1 : rounds);
  constexpr double share_seconds = 8, quick_share_seconds = 0.5;
  if (done && options.wants("shares"))
    done = bench::bench_shares(report, options.quick ? quick_share_seconds : share_seconds);
  if (done && options.wants("geometry")) done = bench::bench_next_wall(report, repeat);
  if (done && options.wants("geometry")) done = bench::bench_next_shape(report, repeat);
  if (done && options.wants("film")) done = bench::bench_flow(report, repeat, options.quick);
  if (done && !options.json.empty()) done = io::write_file_atomically(options.json, report.json());
  if (done && !options.update.empty()) done = bench::update_page(options.update, report.markdown());
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures Shabon on this machine; about nine minutes. Keep the machine free of other work.");
  Options options;
  app.add_flag("--quick", options.quick, "Few repetitions: to see that everything runs");
  app.add_option("--only", options.only, "Some of: optics, desk, render, noise, transports, shares, geometry, film")
      ->delimiter(',')
      ->check(CLI::IsMember({"optics", "desk", "render", "noise", "transports", "shares", "geometry", "film"}));
  app.add_option("--json", options.json, "Also writes all figures to this file");
  app.add_option("--update", options.update, "Also puts the report into this page, between its bench marks");
  constexpr int usage = 2;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage;
  }
  bench::Report report;
  const Status done = run(options, report);
  if (done) return 0;
  std::fputs(to_text(done.errors()).c_str(), stderr);
  return static_cast<int>(done.errors().front().failure);
}
