// A table of keys and values beside what was made with them, so that a later run can tell whether it is the same.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shabon/base/result.h"

namespace shabon::app {

using KeyValues = std::vector<std::pair<std::string, std::string>>;

// A CSV of two columns, key and value. Errors: Failure::file.
Status write_key_values(const std::filesystem::path& path, const KeyValues& values);

// Errors: Failure::file, Failure::content when it is damaged.
Result<KeyValues> read_key_values(const std::filesystem::path& path);

// The first key whose value is not the same, as "level: 4 in 'run/film.csv', 3 in 'run/checkpoint.bin'"; one of the two
// may be "not given". Numbers are the same however they are written, the order of keys does not count.
std::optional<std::string> first_difference(const KeyValues& a, const std::string& a_place, const KeyValues& b,
                                            const std::string& b_place);

}  // namespace shabon::app
