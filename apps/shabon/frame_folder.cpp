#include "frame_folder.h"

#include <fmt/format.h>

#include <system_error>

#include "shabon/base/text.h"
#include "streams.h"

namespace shabon::app {

namespace {

namespace fs = std::filesystem;

bool holds_frames(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const auto parts = split(name, '.');
    if (parts.size() == 3 && parts[0] == "frame" && parse_integer(parts[1])) return true;
  }
  return false;
}

}  // namespace

Status check_frame_folder(const fs::path& folder, const KeyValues& values, Diagnostics& warnings) {
  if (!holds_frames(folder)) return Done{};
  const fs::path file = folder / animation_name;
  const std::string name = printable(folder.string());
  std::error_code error;
  if (!fs::exists(file, error)) {
    warnings.push_back(
        warning_of(fmt::format("'{}' holds frames but no {} that tells what they show, as older versions left it: they "
                               "are taken for frames of "
                               "this scene; where they are not, remove them",
                               name, animation_name)));
    return Done{};
  }
  const auto there = read_key_values(file);
  if (!there) return there.errors();
  if (const auto difference = first_difference(*there, "'" + printable(file.string()) + "'", values, "what is asked"))
    return fail(Failure::usage, fmt::format("'{}' holds frames of another animation: {}; expected the same scene and "
                                            "settings, another folder, or one without frames",
                                            name, *difference));
  return Done{};
}

}  // namespace shabon::app
