#include "bench/scenes.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "shabon/api/resources.h"
#include "shabon/base/random.h"
#include "shabon/io/file.h"
#include "shabon/scene/built_in.h"
#include "shabon/scene/compile.h"

namespace shabon::bench {

namespace {

Result<scene::Scene> load(std::string_view file, const std::vector<std::string>& overrides,
                          const std::string& folder = SHABON_BENCH_DATA) {
  constexpr std::size_t most_bytes = 1 << 16;
  const auto text = io::read_text_file(file, most_bytes);
  if (!text) return text.errors();
  return scene::load_scene(*text, std::string(file), overrides, api::file_resources(folder));
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

Result<scene::Scene> many_bubbles(int count) {
  Pcg32 random(1);
  std::string objects = "objects=[";
  for (int i = 0; i < count; ++i)
    objects += fmt::format(
        "{{bubble: {{center: [{:.4f}, {:.4f}, {:.4f}], radius: {:.4f}, film: {{medium: 1.333, thickness: "
        "{{linear: {{top_nm: 150, bottom_nm: 900}}}}}}}}}}, ",
        random.uniform(-1.6, 1.6), random.uniform(-1.2, 1.2), random.uniform(-2, 0.5), random.uniform(0.05, 0.25));
  return load_windows({objects + "]", "image.width=400", "image.height=300"});
}

Result<scene::Scene> gallery_scene(const std::string& name) {
  const std::string folder = std::string(SHABON_BENCH_GALLERY) + "/" + name;
  return load(folder + "/scene.yaml", {}, folder);
}

}  // namespace shabon::bench
