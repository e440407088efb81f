// Renders a scene into a sensor: passes over the whole picture, tile by tile.
#pragma once

#include <cstdint>
#include <optional>

#include "shabon/base/progress.h"
#include "shabon/base/result.h"
#include "shabon/render/sensor.h"
#include "shabon/scene/scene.h"

namespace shabon::render {

struct RenderOptions {
  int threads = 0;                         // 0: one per core; never changes the picture
  ProgressReport progress;                 // called between tiles
  const StopFlag* stop = nullptr;          // when set, tiles not yet begun are left out
  std::optional<double> grey_reflectance;  // benchmarks only: every film reflects this share at every wavelength
};

struct RenderReport {
  int samples_done = 0;  // samples that every pixel has
  bool interrupted = false;
  std::uint64_t camera_samples = 0;  // more than samples times pixels: those on a bubble's rim get four times as many
  std::uint64_t rays = 0;            // straight segments whose next wall was looked for
  std::uint64_t film_events = 0;
  std::uint64_t cut_paths = 0;  // events at which max_depth passed R + T straight on, or two-beam dropped the path
  std::uint64_t dropped_samples = 0;  // contributions left out because they were not finite numbers
  double seconds = 0;
};

// Adds scene.render.samples samples per pixel. The sensor must have the scene's size. The same scene and seed give the
// same bits for any number of threads, on machines with the same instruction set. Errors: a sensor of another size.
Result<RenderReport> render(const scene::Scene& scene, const RenderOptions& options, Sensor& sensor);

// "x86-64-v4", "x86-64-v3" or "x86-64": the instruction set this build of the renderer uses.
const char* instruction_set();

}  // namespace shabon::render
