// What a scene file says, value by value, to be written beside pictures and compared with others.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::scene {

// Every value by its path ("objects[0].bubble.radius"), in the order of the file after `overrides`. Comments, quotes
// and the way it is laid out make no difference; defaults that the file leaves out are not among them. Errors: a text
// that is no YAML, an override that leads nowhere. Whether the values mean a scene is not looked at.
Result<std::vector<std::pair<std::string, std::string>>> scene_values(std::string_view text, std::string source,
                                                                      std::span<const std::string> overrides);

}  // namespace shabon::scene
