// The library of media: one list with sources, told in docs/media.md.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::optics {

struct MediumEntry {
  std::string_view name;
  std::vector<std::string_view> aliases;  // other names of the same medium
  Medium medium;
};

// All media, in the order of listings. Names, descriptions, sources and ranges are the media's own.
std::span<const MediumEntry> media_library();

// The names without aliases.
std::vector<std::string_view> media_names();

// The medium of that name or alias; both ignore case.
std::optional<Medium> find_medium(std::string_view name);

// The same with an error that suggests the nearest known name.
Result<Medium> medium_named(std::string_view name);

}  // namespace shabon::optics
