#include "scene_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "options.h"
#include "shabon/api/resources.h"
#include "shabon/io/file.h"
#include "shabon/io/yaml.h"
#include "shabon/optics/interference.h"
#include "shabon/scene/built_in.h"
#include "shabon/scene/compile.h"
#include "shabon/scene/scene_values.h"
#include "shabon/scene/schema_fields.h"
#include "streams.h"

namespace shabon::app {

namespace {

// "800x600".
void read_size(SceneInput& input, const std::string& text) {
  const std::string option = "--size";
  const std::string size = lower(text);
  const std::vector<std::string_view> sides = split(size, 'x');
  if (sides.size() != 2 || !parse_integer(trim(sides[0])) || !parse_integer(trim(sides[1])))
    usage_error(option, fmt::format("expected WxH such as 800x600, got '{}'", printable(text, 60)));
  const auto side = [&](std::string_view digits) {
    return integer_in(option, digits, static_cast<long long>(scene::side_range.low),
                      static_cast<long long>(scene::side_range.high));
  };
  const long long width = side(sides[0]), height = side(sides[1]);
  if (static_cast<double>(width) * static_cast<double>(height) > scene::most_pixels)
    usage_error(option, fmt::format("expected at most 2^28 pixels, got {}", width * height));
  input.flags.push_back(fmt::format("image.width={}", width));
  input.flags.push_back(fmt::format("image.height={}", height));
}

struct SceneText {
  std::string text, name;
};

Result<SceneText> text_of(const SceneInput& input) {
  if (!input.file) return SceneText{std::string(scene::built_in_scene()), std::string(scene::built_in_source)};
  Result<std::string> content = io::read_text_file(*input.file, io::yaml_max_bytes);
  if (!content) return content.errors();
  return SceneText{*std::move(content), *input.file};
}

// In the order in which they win.
std::vector<std::string> overrides_of(const SceneInput& input) {
  std::vector<std::string> overrides = input.overrides;
  overrides.insert(overrides.end(), input.flags.begin(), input.flags.end());
  return overrides;
}

}  // namespace

void add_scene_input(CLI::App& app, SceneInput& input) {
  add_text(app, "SCENE", input.file, "", "Scene file (.yaml or .json); none: the built-in bubble");
  add_texts(app, "--set", input.overrides, "PATH=VALUE",
            "Set a value of the scene, such as objects[0].bubble.radius=2; may be repeated");
  app.add_option_function<std::string>(
         "--size", [&input](const std::string& text) { read_size(input, text); }, "Size of the picture in pixels")
      ->type_name("WxH");
  std::vector<std::string_view> models;
  models.reserve(std::size(optics::interference_models));
  for (const auto& model : optics::interference_models) models.push_back(model.name);
  add_scene_name(app, input, "--interference", "render.interference", models, "Model of interference");
}

void add_scene_name(CLI::App& app, SceneInput& input, const std::string& names, const std::string& path,
                    const std::vector<std::string_view>& known, const std::string& description) {
  const auto read = [&input, names, path, known](const std::string& text) {
    const std::string name = lower(text);
    if (std::find(known.begin(), known.end(), name) == known.end())
      usage_error(names, unknown_name("value", text, known));
    input.flags.push_back(path + "=" + name);
  };
  app.add_option_function<std::string>(names, read, fmt::format("{}: {}", description, fmt::join(known, ", ")))
      ->type_name("NAME");
}

void add_scene_integer(CLI::App& app, SceneInput& input, const std::string& names, const std::string& path, Range range,
                       const std::string& description) {
  const auto least = static_cast<long long>(range.low);
  const auto most = range.has_high() ? static_cast<long long>(range.high) : std::numeric_limits<long long>::max();
  const auto read = [&input, names, path, least, most](const std::string& text) {
    input.flags.push_back(fmt::format("{}={}", path, integer_in(names, text, least, most)));
  };
  app.add_option_function<std::string>(names, read, description)->type_name("N");
}

Result<LoadedScene> load(const SceneInput& input, scene::CameraUse camera) {
  auto read = text_of(input);
  if (!read) return read.errors();
  auto& [text, name] = *read;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> files_read;
  if (input.file) {
    folder = std::filesystem::path(name).parent_path();
    files_read.push_back(name);
  }
  const auto note = [&files_read](const std::filesystem::path& file) { files_read.push_back(file); };
  Diagnostics warnings;
  Result<scene::Scene> scene =
      scene::load_scene(text, name, overrides_of(input), api::file_resources(folder, note), &warnings, camera);
  if (input.warn) report(warnings);
  if (!scene) return scene.errors();
  return LoadedScene{*std::move(scene), std::move(name), std::move(files_read)};
}

Result<std::vector<std::pair<std::string, std::string>>> scene_values(const SceneInput& input) {
  const auto read = text_of(input);
  if (!read) return read.errors();
  return scene::scene_values(read->text, read->name, overrides_of(input));
}

}  // namespace shabon::app
