// The keys of a scene file as documentation.
#pragma once

#include <string>

namespace shabon::scene {

// A Markdown table of every key: path, type, default, range, meaning. docs/scene-file.md holds it; a test compares.
std::string reference_table();

}  // namespace shabon::scene
