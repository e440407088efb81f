// The scene that is rendered when none is named: scenes/studio-bubble, compiled in.
#pragma once

#include <string_view>

namespace shabon::scene {

// The text of the scene file. It names no other files.
std::string_view built_in_scene();

// What stands in place of a file name in its messages.
inline constexpr std::string_view built_in_source = "<built-in scene>";

}  // namespace shabon::scene
