// The scenes of the gallery, small.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "shabon/api/resources.h"
#include "shabon/io/file.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/running_films.h"

namespace shabon::test {

inline const std::filesystem::path gallery_folder = std::filesystem::path(SHABON_SOURCE_DIR) / "scenes";

inline std::set<std::string> gallery_names() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(gallery_folder))
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  return names;
}

// So wide, as high as the scene's own picture asks for, with its simulated films as they are at its time.
inline Result<scene::Scene> gallery_scene(const std::string& name, int width) {
  const std::filesystem::path path = gallery_folder / name / "scene.yaml";
  const Result<std::string> text = io::read_text_file(path, io::yaml_max_bytes);
  if (!text) return text.errors();
  const auto resources = api::file_resources(path.parent_path());
  const Result<scene::Scene> whole = scene::load_scene(*text, path.string(), {}, resources);
  if (!whole) return whole;
  const int height = std::max(1, (width * whole->height + whole->width / 2) / whole->width);
  const std::vector<std::string> overrides = {"image.width=" + std::to_string(width),
                                              "image.height=" + std::to_string(height)};
  auto scene = scene::load_scene(*text, path.string(), overrides, resources);
  if (!scene) return scene;
  if (const Status ran = scene::run_films(*scene); !ran) return ran.errors();
  return scene;
}

}  // namespace shabon::test
