#include "bench/scenes.h"

#include <string>
#include <vector>

#include "shabon/api/resources.h"
#include "shabon/io/file.h"
#include "shabon/scene/built_in.h"
#include "shabon/scene/compile.h"

namespace shabon::bench {

namespace {

Result<scene::Scene> load(std::string_view file, const std::vector<std::string>& overrides) {
  constexpr std::size_t most_bytes = 1 << 16;
  const auto text = io::read_text_file(file, most_bytes);
  if (!text) return text.errors();
  return scene::load_scene(*text, std::string(file), overrides, api::file_resources(SHABON_BENCH_DATA));
}

Result<scene::Scene> load_windows(const std::vector<std::string>& overrides) {
  return load(SHABON_BENCH_DATA "/windows-bubble.yaml", overrides);
}

}  // namespace

Result<scene::Scene> built_in_bubble() {
  return scene::load_scene(scene::built_in_scene(), std::string(scene::built_in_source), {}, {});
}

Result<scene::Scene> windows_bubble(double rotation_deg) {
  return load_windows({"environment.image.rotation_deg=" + std::to_string(rotation_deg)});
}

Result<scene::Scene> plain_bubble(std::string_view medium, std::string_view interference) {
  return load_windows({"environment.constant={illuminant: D65}", "objects[0].bubble.film.medium=" + std::string(medium),
                       "render.interference=" + std::string(interference)});
}

Result<scene::Scene> coated_room() { return load(SHABON_BENCH_DATA "/coated-room.yaml", {}); }

}  // namespace shabon::bench
