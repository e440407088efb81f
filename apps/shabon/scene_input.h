// What render and probe share: the scene, and the flags that stand for values of its file.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/base/result.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/scene.h"

namespace shabon::app {

struct SceneInput {
  std::optional<std::string> file;     // none: the built-in bubble
  std::vector<std::string> overrides;  // "path=value", later ones win
  std::vector<std::string> flags;      // the same, from flags of their own; they win over `overrides`
  bool warn = true;                    // print warnings
};

void add_scene_input(CLI::App& app, SceneInput& input);

// A flag that stands for a whole number of the scene file, such as render.samples.
void add_scene_integer(CLI::App& app, SceneInput& input, const std::string& names, const std::string& path, Range range,
                       const std::string& description);

// A flag that stands for one of a closed set of names in the scene file, such as render.transport.
void add_scene_name(CLI::App& app, SceneInput& input, const std::string& names, const std::string& path,
                    const std::vector<std::string_view>& known, const std::string& description);

struct LoadedScene {
  scene::Scene scene;
  std::string name;                               // the file as given, or "<built-in scene>"
  std::vector<std::filesystem::path> files_read;  // the scene and every file it names
};

// Reads and compiles the scene; files it names are found beside it. Prints warnings.
Result<LoadedScene> load(const SceneInput& input, scene::CameraUse camera = scene::CameraUse::takes_pictures);

// Every value of the scene by its path, flags included, as scene::scene_values().
Result<std::vector<std::pair<std::string, std::string>>> scene_values(const SceneInput& input);

}  // namespace shabon::app
