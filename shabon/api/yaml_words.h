// The words of a YAML scalar, each with its place: "0.2 1.1\n0.3 1.2" is four of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shabon/io/yaml.h"

namespace shabon::api {

// Separated by white space. The views live as long as `text`.
std::vector<std::string_view> words_of(std::string_view text);

// An error of Failure::content that points at the word numbered `word` (from 0) of a scalar, or at the scalar where the
// file does not show its words one by one.
Diagnostic diagnostic_at_word(const io::YamlDocument& document, const io::YamlNode& scalar, std::size_t word,
                              std::string message);

}  // namespace shabon::api
