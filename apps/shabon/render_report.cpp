#include "render_report.h"

#include <fmt/format.h>

#include "json.h"
#include "shabon/api/version.h"
#include "shabon/optics/interference.h"
#include "streams.h"

namespace shabon::app {

io::Metadata picture_metadata(const LoadedScene& loaded, const std::vector<std::string>& overrides,
                              const render::RenderReport& done) {
  const scene::RenderSettings& settings = loaded.scene.render;
  io::Metadata metadata{
      {"Software", fmt::format("shabon {}", version())},
      {"scene", loaded.name},
      {"seed", std::to_string(settings.seed)},
      {"samples", std::to_string(done.samples_done)},
      {"version", std::string(version())},
      {"interference", std::string(optics::name_of(settings.interference))},
  };
  if (!overrides.empty()) metadata.emplace_back("set", fmt::format("{}", fmt::join(overrides, "; ")));
  return metadata;
}

std::string stats_json(const LoadedScene& loaded, const render::RenderReport& done) {
  const scene::RenderSettings& settings = loaded.scene.render;
  const double seconds = done.seconds;
  const auto rate = [seconds](std::uint64_t count) { return seconds > 0 ? static_cast<double>(count) / seconds : 0; };
  JsonObject json;
  json.add("version", version()).add("instruction_set", render::instruction_set()).add("scene", loaded.name);
  json.add("width", loaded.scene.width).add("height", loaded.scene.height);
  json.add("samples", settings.samples).add("samples_done", done.samples_done).add("seed", settings.seed);
  json.add("interference", optics::name_of(settings.interference)).add("interrupted", done.interrupted);
  json.add("seconds", seconds).add("camera_samples", done.camera_samples).add("rays", done.rays);
  json.add("film_events", done.film_events).add("cut_paths", done.cut_paths);
  json.add("dropped_samples", done.dropped_samples);
  json.add("camera_samples_per_second", rate(done.camera_samples)).add("rays_per_second", rate(done.rays));
  json.add("film_events_per_second", rate(done.film_events));
  return json.text();
}

namespace {

bool is_black(const render::Sensor& sensor) {
  for (int y = 0; y < sensor.height(); ++y)
    for (int x = 0; x < sensor.width(); ++x)
      if (const auto& pixel = sensor.at(x, y); pixel.x != 0 || pixel.y != 0 || pixel.z != 0) return false;
  return true;
}

}  // namespace

Diagnostics render_warnings(const render::RenderReport& done, const render::Sensor& sensor) {
  Diagnostics warnings;
  if (done.dropped_samples > 0)
    warnings.push_back(
        warning_of(fmt::format("{} contributions were not finite numbers and were left out", done.dropped_samples)));
  if (!done.interrupted && is_black(sensor))
    warnings.push_back(
        warning_of("the whole picture is black: no light reaches the camera. Does it stand inside something opaque? Do "
                   "lamps face away from what they should light, or lie behind it?"));
  return warnings;
}

std::string interruption_message(const render::Sensor& sensor) {
  const auto [least, most] = sensor.sample_range();
  if (least == 0) return "interrupted; the picture has parts without a sample, which are black";
  return fmt::format("interrupted; the picture has {} to {} samples a pixel", least, most);
}

}  // namespace shabon::app
