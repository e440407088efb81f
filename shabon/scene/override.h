// Values set from outside the file: `--set objects[0].bubble.radius=2`.
#pragma once

#include <string_view>

#include "shabon/base/result.h"
#include "shabon/io/yaml.h"
#include "shabon/scene/schema.h"

namespace shabon::scene {

// Sets the value at `path` in a parsed scene file, before it is read: the same checks and messages follow, with
// override_source in place of the file name. `value` is YAML, so lists and mappings can be set whole. Keys that the
// file leaves out are added; a key of one choice (environment.gradient, film.stack, ...) replaces those of the others.
// Errors leave the document as it was. Failure::usage: what is no path at all; Failure::content, as for the file
// itself: a path that leads nowhere, with the nearest known key, and a value that is no YAML. Where the path is right
// but the file is not (a list where a mapping belongs), the error is that of the file, at its place. `root` is what the
// file may hold.
Status set_value(io::YamlDocument& document, std::string_view path, std::string_view value,
                 const Mapping& root = scene_schema());

// The same from one text "path=value".
Status apply_override(io::YamlDocument& document, std::string_view assignment, const Mapping& root = scene_schema());

}  // namespace shabon::scene
