#include "bench/render/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "bench/render/peers.h"
#include "bench/scenes.h"
#include "shabon/render/develop.h"
#include "shabon/render/render.h"

namespace shabon::bench {

namespace {

constexpr int threads = 2;
constexpr double grey_reflectance = 0.08;
constexpr double most_seconds_times_mse = 5e-6;
constexpr int goal_samples = 64;

using Pixels = std::vector<float>;  // linear RGB

double mean_squared_difference(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = double(a[i]) - double(b[i]);
    sum += d * d;
  }
  return sum / static_cast<double>(a.size());
}

// How much of the squared difference lies in the hundredth of the pixels that differ most.
double share_of_worst(const Pixels& a, const Pixels& b) {
  std::vector<double> errors(a.size() / 3);
  double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      errors[i] += (double(a[c]) - double(b[c])) * (double(a[c]) - double(b[c]));
    sum += errors[i];
  }
  const auto rest = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 100);
  std::nth_element(errors.begin(), rest, errors.end(), std::greater<>());
  double worst = 0;
  for (auto e = errors.begin(); e != rest; ++e) worst += *e;
  return sum > 0 ? worst / sum : 0;
}

// Pictures of one scene with one number of samples, each with its own seed.
struct Series {
  int samples;
  std::vector<Pixels> pictures;
  std::vector<double> seconds, processor_seconds;

  void render(scene::Scene scene, std::optional<double> grey, int count) {
    render::RenderOptions options;
    options.threads = threads;
    options.grey_reflectance = grey;
    scene.render.samples = samples;
    for (int i = 0; i < count; ++i) {
      scene.render.seed = static_cast<std::uint64_t>(1000 * samples + i);
      render::Sensor sensor(scene.width, scene.height);
      const std::clock_t start = std::clock();
      if (const auto done = render::render(scene, options, sensor)) seconds.push_back(done->seconds);
      processor_seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      pictures.push_back(render::develop_linear(sensor).rgb);
    }
  }

  // Half the mean squared difference, of each pair of seeds.
  Spread mse() const {
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < pictures.size(); i += 2)
      values.push_back(0.5 * mean_squared_difference(pictures[i], pictures[i + 1]));
    return spread_of(std::move(values));
  }
};

struct Subject {
  const char* name;
  double rotation_deg = 0;
  std::optional<double> grey;
  std::vector<Series> series;
};

std::string shown_small(const Spread& s) {
  return s.count > 1 ? fmt::format("{:.1e} ({:.1e}..{:.1e})", s.median, s.least, s.most)
                     : fmt::format("{:.1e}", s.median);
}

// Adds the rows of one subject; returns seconds x MSE at 64 samples, or 0 where it was not measured.
double add_rows(Report& report, Table& table, const Subject& subject) {
  double at_goal = 0;
  const Series& finest = subject.series.back();
  for (const Series& series : subject.series) {
    const Spread mse = series.mse(), seconds = spread_of(series.seconds);
    const double product = mse.median * seconds.median;
    if (series.samples == goal_samples) at_goal = product;
    std::vector<double> against;
    for (const Pixels& picture : series.pictures)
      if (&series != &finest) against.push_back(mean_squared_difference(picture, finest.pictures.front()));
    const std::string name = fmt::format("{}, {} samples", subject.name, series.samples);
    report.record("noise", name, "MSE of linear RGB", mse);
    report.record("noise", name, "seconds", seconds);
    report.record("noise", name, "processor seconds", spread_of(series.processor_seconds));
    report.record("noise", name, "seconds x MSE", {product, product, product, 1});
    table.add({subject.name, std::to_string(series.samples), shown(seconds, 2),
               fmt::format("{:.2f}", spread_of(series.processor_seconds).median), shown_small(mse),
               against.empty() ? "" : fmt::format("{:.1e}", spread_of(against).median), fmt::format("{:.1e}", product),
               fmt::format("{:.0f} %", 100 * share_of_worst(series.pictures[0], series.pictures[1]))});
  }
  return at_goal;
}

std::string decline(const Subject& subject) {
  const Series &first = subject.series.front(), &last = subject.series.back();
  const double power =
      std::log(last.mse().median / first.mse().median) / std::log(double(last.samples) / first.samples);
  return fmt::format("{}: N^{:.1f}", subject.name, power);
}

void report_peers(Report& report) {
  report.paragraph(peers_source);
  Table table({"renderer", "film", "million samples/s", "MSE", "seconds x MSE"});
  for (const Peer& peer : peers)
    table.add({peer.name, peer.film, peer.million_samples_per_second, peer.mse, peer.seconds_times_mse});
  report.table(table);
}

}  // namespace

Status bench_noise(Report& report, bool thorough) {
  const std::pair<int, int> plan[] = {{16, 8}, {64, 4}, {256, 2}};  // samples, seeds
  std::vector<Subject> subjects{{"Airy", 0, {}, {}}};
  if (thorough) {
    subjects.push_back({"Airy, turned by 90", 90, {}, {}});
    subjects.push_back({"Airy, turned by -90", -90, {}, {}});
    subjects.push_back({"grey", 0, grey_reflectance, {}});
  }
  for (Subject& subject : subjects) {
    const auto scene = windows_bubble(subject.rotation_deg);
    if (!scene) return scene.errors();
    for (const auto& [samples, seeds] : plan) {
      if ((!thorough || &subject != &subjects.front()) && samples > goal_samples) continue;
      std::fprintf(stderr, "bench: noise, %s, %d samples\n", subject.name, samples);
      subject.series.push_back({samples, {}, {}, {}});
      subject.series.back().render(*scene, subject.grey, thorough ? seeds : 2);
    }
  }
  report.heading("Seconds x error");
  report.paragraph(fmt::format(
      "The bubble under the windows, {} threads. The error is the mean squared error of linear RGB, estimated from "
      "two\n"
      "seeds as half their mean squared difference (several pairs: median and range). All seeds share the same\n"
      "wavelengths, so what too few wavelengths do shows only in the column `from finest`, the mean squared difference "
      "from\n"
      "the picture with most samples. Most of the error is at the rim, so it matters what stands behind it: a window "
      "of\n"
      "radiance 11; with the surroundings turned by 90 degrees the edge of one, by -90 degrees one of radiance 16.\n"
      "`Worst 1 %` is the share of the error in the hundredth of the pixels that have most. `Processor` is the "
      "processor\n"
      "time of both threads.",
      threads));
  Table table({"film", "samples", "seconds", "processor", "MSE", "from finest", "seconds x MSE", "worst 1 %"});
  double at_goal = 0;
  for (const Subject& subject : subjects) {
    const double product = add_rows(report, table, subject);
    if (&subject == &subjects.front()) at_goal = product;
  }
  report.table(table);
  std::string declines = "The error falls with the number N of samples as";
  for (const Subject& subject : subjects) declines += (&subject == &subjects.front() ? " " : "; ") + decline(subject);
  report.paragraph(declines + ".");
  report.paragraph(verdict(at_goal < most_seconds_times_mse, "Goal of 5e-6 for seconds x MSE at 64 samples") +
                   fmt::format(" ({:.1e}).", at_goal));
  report_peers(report);
  return Done{};
}

}  // namespace shabon::bench
