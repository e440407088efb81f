#include "bench/render/shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "bench/sampler.h"
#include "bench/scenes.h"
#include "shabon/render/render.h"

namespace shabon::bench {

namespace {

struct Part {
  const char* name;
  std::vector<std::string_view> files;  // a piece of the path of any source file that belongs to it
};

// The order decides: a file that belongs to nobody, as those of packets and vectors, goes with whoever called it.
const std::vector<Part>& parts() {
  static const std::vector<Part> list = {
      {"Embree", {}},
      {"other geometry", {"shabon/geometry/", "next_walls.h", "event_block.h", "camera_rays.h", "rim.h", "camera.h"}},
      {"optics", {"shabon/optics/", "film_optics", "coating_table", "pane_table", "rest_table", "facet_powers.h"}},
      {"scattering", {"microfacet", "lobe", "base_brightness", "surfaces/"}},
      {"textures and surroundings", {"texture", "environment", "scene/lights/", "math/raster.h"}},
      {"lamps", {"lamp"}},
      {"film thickness", {"shabon/film/"}},
      {"paths, sums, rest", {}},
  };
  return list;
}

std::size_t part_of(const Place& place) {
  if (place.object.find("embree") != std::string::npos) return 0;
  for (const std::string& file : place.files)
    for (std::size_t part = 0; part < parts().size(); ++part)
      for (const std::string_view piece : parts()[part].files)
        if (file.find(piece) != std::string::npos) return part;
  return parts().size() - 1;
}

struct Subject {
  const char* name;
  Result<scene::Scene> scene;
};

double seconds_of(scene::Scene scene, int samples) {
  scene.render.samples = samples;
  render::Sensor sensor(scene.width, scene.height);
  render::RenderOptions options;
  options.threads = 1;
  const auto done = render::render(scene, options, sensor);
  return done ? done->seconds : 0;
}

}  // namespace

Status bench_shares(Report& report, double seconds) {
  Subject subjects[] = {{"bubble under the windows", windows_bubble()},
                        {"64 bubbles", many_bubbles(64)},
                        {"white room with coated things", coated_room()},
                        {"wet asphalt (gallery)", gallery_scene("wet-asphalt")}};
  report.heading("What the time goes into");
  report.paragraph(
      "Shares of the processor time of a render on one thread, in percent. At each tick of a timer (up to 1000\n"
      "a second) the place in the code is noted; functions that the compiler put into others count where their source "
      "stands (bench/render/shares.cpp).");
  std::vector<std::string> head = {"scene", "ticks"};
  for (const Part& part : parts()) head.push_back(part.name);
  Table table(head);
  for (const Subject& subject : subjects) {
    if (!subject.scene) return subject.scene.errors();
    std::fprintf(stderr, "bench: shares, %s\n", subject.name);
    const double one = std::max(seconds_of(*subject.scene, 1), 1e-3);
    const int samples = std::max(1, static_cast<int>(seconds / one));
    const auto places = sampled([&] { seconds_of(*subject.scene, samples); });
    if (!places) return places.errors();
    std::vector<std::uint64_t> ticks(parts().size(), 0);
    std::uint64_t all = 0;
    for (const Place& place : *places) ticks[part_of(place)] += place.ticks, all += place.ticks;
    std::vector<std::string> row = {subject.name, std::to_string(all)};
    for (std::size_t part = 0; part < parts().size(); ++part) {
      const double share =
          100.0 * static_cast<double>(ticks[part]) / static_cast<double>(std::max<std::uint64_t>(all, 1));
      row.push_back(fmt::format("{:.0f}", share));
      report.record("shares", fmt::format("{}, {}", subject.name, parts()[part].name), "percent", spread_of({share}));
    }
    table.add(row);
  }
  report.table(table);
  return Done{};
}

}  // namespace shabon::bench
