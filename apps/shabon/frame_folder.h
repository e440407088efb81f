// The folder of an animation's frames, which belong to one scene: animation.csv says which.
#pragma once

#include <filesystem>
#include <string_view>

#include "key_values.h"
#include "shabon/base/result.h"

namespace shabon::app {

inline constexpr std::string_view animation_name = "animation.csv";

// Whether frames may be added to the folder that show what `values` say. Frames that are there but have no
// animation.csv, those of older versions, get a warning. Errors: Failure::usage when they show something else, with the
// first key that differs; those of read_key_values().
Status check_frame_folder(const std::filesystem::path& folder, const KeyValues& values, Diagnostics& warnings);

}  // namespace shabon::app
