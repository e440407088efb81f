#include "shabon/render/render.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "shabon/base/parallel.h"
#include "shabon/render/idle_films.h"
#include "shabon/render/kernel/scattering/tile.h"
#include "shabon/render/kernel/transport.h"

namespace shabon::render {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<Tile> tiles_of(const scene::Scene& scene) {
  std::vector<Tile> tiles;
  for (int y = 0; y < scene.height; y += tile_size)
    for (int x = 0; x < scene.width; x += tile_size)
      tiles.push_back({x, y, std::min(tile_size, scene.width - x), std::min(tile_size, scene.height - y)});
  return tiles;
}

// The samples of one pass over the picture. Early passes are short, so that a picture that is stopped early is whole.
int samples_of_pass(int pass) {
  constexpr int first_passes[] = {4, 12};
  return pass < 2 ? first_passes[pass] : 16;
}

class Progress {
 public:
  Progress(const ProgressReport& report, double total) : report_(report), total_(total) {}
  void add(double work) {
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    done_ += work;
    report_(std::min(1.0, done_ / total_));
  }

 private:
  const ProgressReport& report_;
  double total_, done_ = 0;
  std::mutex mutex_;
};

// Each thread keeps its arrays from tile to tile; whoever is free takes one.
template <class Transport, class Tables>
class Workers {
 public:
  explicit Workers(const Tables& tables) : tables_(tables) {}
  std::unique_ptr<Transport> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<Transport>(tables_);
    auto worker = std::move(free_.back());
    free_.pop_back();
    return worker;
  }
  void give_back(std::unique_ptr<Transport> worker) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(worker));
  }
  void count(RenderReport& report) const {
    for (const auto& worker : free_) {
      const TransportCounts counts = worker->counts();
      report.camera_samples += counts.camera_samples;
      report.rays += counts.rays;
      report.film_events += counts.film_events;
      report.cut_paths += counts.cut_paths;
      report.dropped_samples += counts.dropped;
    }
  }

 private:
  const Tables& tables_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Transport>> free_;
};

template <class Transport>
void render_tile(Transport& worker, const Tile& tile, std::uint32_t first, std::uint32_t end, Sensor& sensor) {
  worker.add_samples(tile, first, end);
  std::vector<std::array<double, 3>> xyz;
  worker.take_sums(tile, xyz);
  for (int i = 0; i < tile.pixels(); ++i) {
    Sensor::Pixel& pixel = sensor.at(tile.x0 + i % tile.width, tile.y0 + i / tile.width);
    const auto& sum = xyz[static_cast<std::size_t>(i)];
    pixel.x += sum[0], pixel.y += sum[1], pixel.z += sum[2];
    pixel.samples += end - first;
  }
}

template <class Transport, class Tables>
RenderReport render_with(const Tables& tables, const RenderOptions& options, Sensor& sensor) {
  const scene::Scene& scene = tables.scene;
  const std::vector<Tile> tiles = tiles_of(scene);
  Workers<Transport, Tables> workers(tables);
  Progress progress(options.progress, double(tiles.size()) * scene.render.samples);
  const auto stopped = [&] { return options.stop && options.stop->load(std::memory_order_relaxed); };
  RenderReport report;
  for (int pass = 0, first = 0; first < scene.render.samples && !report.interrupted; ++pass) {
    const int end = std::min(first + samples_of_pass(pass), scene.render.samples);
    std::atomic<bool> left_out{false};
    parallel_for(tiles.size(), options.threads, [&](std::size_t i) {
      if (stopped()) {
        left_out = true;
        return;
      }
      auto worker = workers.take();
      render_tile(*worker, tiles[i], static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), sensor);
      workers.give_back(std::move(worker));
      progress.add(end - first);
    });
    report.interrupted = left_out;
    if (!left_out) report.samples_done = end;
    first = end;
  }
  workers.count(report);
  return report;
}

// Only bubbles under lamps at infinity, seen through a pinhole: a kernel of their own follows many of their paths side
// by side.
bool only_bubbles(const scene::Scene& scene) {
  return scene.objects.empty() && scene.camera.is_pinhole() && scene.render.transport == scene::Transport::tree;
}

}  // namespace

Result<RenderReport> render(const scene::Scene& scene, const RenderOptions& options, Sensor& sensor) {
  if (sensor.width() != scene.width || sensor.height() != scene.height)
    return fail(Failure::internal, "expected a sensor of the scene's size");
  if (const Status ran = check_films_ran(scene); !ran) return ran.errors();
  const auto start = Clock::now();
  RenderReport report = only_bubbles(scene)
                            ? render_with<TileTransport>(SceneTables(scene, options.grey_reflectance), options, sensor)
                            : render_with<ScatteringTile>(ScatteringTables(scene), options, sensor);
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return report;
}

const char* instruction_set() {
  return math::register_bytes == 64 ? "x86-64-v4" : math::register_bytes == 32 ? "x86-64-v3" : "x86-64";
}

}  // namespace shabon::render
