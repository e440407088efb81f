#include "bench/render/transports.h"

#include <fmt/format.h>

#include <cstdio>

#include "bench/scenes.h"
#include "shabon/render/render.h"

namespace shabon::bench {

namespace {

constexpr int threads = 2;
constexpr double wanted_relative_error = 0.01;

std::vector<double> luminances(const render::Sensor& sensor) {
  std::vector<double> y;
  for (int row = 0; row < sensor.height(); ++row)
    for (int column = 0; column < sensor.width(); ++column) y.push_back(sensor.mean(column, row).y);
  return y;
}

struct Picture {
  std::vector<double> y;
  double seconds = 0;
};

Picture picture_of(scene::Scene scene, std::uint64_t seed) {
  scene.render.seed = seed;
  render::Sensor sensor(scene.width, scene.height);
  render::RenderOptions options;
  options.threads = threads;
  const auto done = render::render(scene, options, sensor);
  return {luminances(sensor), done ? done->seconds : 0};
}

// Seconds until the root of the mean squared error of Y is a hundredth of the mean Y, as if the squared error fell with
// the number of samples: half the mean squared difference of two seeds stands for it.
double seconds_to_one_percent(const scene::Scene& scene, std::uint64_t seed) {
  const Picture a = picture_of(scene, seed), b = picture_of(scene, seed + 1);
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < a.y.size(); ++i) {
    squares += (a.y[i] - b.y[i]) * (a.y[i] - b.y[i]) / 2;
    sum += (a.y[i] + b.y[i]) / 2;
  }
  const double count = static_cast<double>(a.y.size()), relative = squares / count / (sum / count * sum / count);
  return (a.seconds + b.seconds) / 2 * relative / (wanted_relative_error * wanted_relative_error);
}

struct Subject {
  const char* name;
  scene::Scene scene;
  int tree_samples, path_samples;
  double goal;
};

}  // namespace

Status bench_transports(Report& report, int repetitions) {
  auto bubble = windows_bubble();
  if (!bubble) return bubble.errors();
  auto room = coated_room();
  if (!room) return room.errors();
  const Subject subjects[] = {{"bubble under the windows", *std::move(bubble), 16, 64, 500},
                              {"white room with coated things", *std::move(room), 32, 32, 1}};
  report.heading("Tree against single paths");
  report.paragraph(fmt::format(
      "Seconds on {} threads until the error of Y (root of the mean square over the picture) is 1 % of its mean, as if\n"
      "the squared error fell with the number of samples, as that of single paths does; that of the tree falls faster.",
      threads));
  Table table({"scene", "tree, s", "single paths, s", "ratio", "goal"});
  for (const Subject& subject : subjects) {
    std::vector<double> tree, path, ratio;
    for (int i = 0; i < repetitions; ++i) {
      std::fprintf(stderr, "bench: transports, %s, round %d\n", subject.name, i + 1);
      scene::Scene scene = subject.scene;
      const auto seed = static_cast<std::uint64_t>(2 * i + 1);
      scene.render.samples = subject.tree_samples;
      tree.push_back(seconds_to_one_percent(scene, seed));
      scene.render.samples = subject.path_samples;
      scene.render.transport = scene::Transport::path;
      path.push_back(seconds_to_one_percent(scene, seed));
      ratio.push_back(path.back() / tree.back());
    }
    const Spread ratios = spread_of(ratio);
    report.record("transports", subject.name, "seconds to 1 %, tree", spread_of(tree));
    report.record("transports", subject.name, "seconds to 1 %, single paths", spread_of(path));
    report.record("transports", subject.name, "ratio", ratios);
    table.add({subject.name, shown(spread_of(tree), 3), shown(spread_of(path), 1), shown(ratios, 1),
               verdict(ratios.median >= subject.goal, fmt::format("{:.0f}", subject.goal))});
  }
  report.table(table);
  return Done{};
}

}  // namespace shabon::bench
