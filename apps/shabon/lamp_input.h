// The option --illuminant: a lamp of the library, a temperature, or a file.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"

namespace shabon::app {

// `target` holds the default until the option is given. What it means is known to read_lamp() only.
void add_lamp(CLI::App& app, std::string& target);

// The lamp, or an error of content: an unknown name, a temperature out of range, a broken file. Files are found from
// the working folder. What its note says goes to standard error.
Result<color::Illuminant> read_lamp(const std::string& text);

}  // namespace shabon::app
