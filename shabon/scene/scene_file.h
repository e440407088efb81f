// Scene files: text -> SceneDesc.
#pragma once

#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/scene_desc.h"

namespace shabon::scene {

// What a scene file (YAML or JSON) says. `source` is the name shown in errors. Errors (Failure::content): everything
// that is wrong, in the order of the file, at most Problems::most_shown of it: what parse_yaml rejects, unknown and
// missing keys, wrong types, values outside their range, unknown names, films that cannot be understood. Files that the
// scene names are not opened. Warnings, if wanted, are added to `warnings`.
Result<SceneDesc> read_scene(std::string_view text, std::string source, Diagnostics* warnings = nullptr);

// The same for a file that is parsed already, perhaps with values set by set_value().
Result<SceneDesc> read_scene(io::YamlDocument document, Diagnostics* warnings = nullptr);

// One step of the above: reads what can be read and collects what cannot.
SceneDesc read_description(const std::shared_ptr<const io::YamlDocument>& document, Problems& problems);

}  // namespace shabon::scene
