// What is wrong with the arguments, in our own words: which option, what was expected, what came.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace shabon::app {

// The text for an error that parsing with `root` ended with. `chosen` is the subcommand, or `root` itself.
std::string usage_text(const CLI::App& root, const CLI::App& chosen, const CLI::ParseError& error);

}  // namespace shabon::app
