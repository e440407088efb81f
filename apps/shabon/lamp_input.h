// The options of the lamp: --illuminant, one of the library, a temperature, or a file; --adaptation to it.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "shabon/base/result.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/illuminant.h"

namespace shabon::app {

// `target` holds the default until the option is given. What it means is known to read_lamp() only.
void add_lamp(CLI::App& app, std::string& target);

// The lamp, or an error of content: an unknown name, a temperature out of range, a broken file. Files are found from
// the working folder. What its note says goes to standard error.
Result<color::Illuminant> read_lamp(const std::string& text);

// --adaptation, also --adapt: a method by its name, or none.
CLI::Option* add_adaptation(CLI::App& app, std::optional<color::Adaptation>& target, const std::string& description);

}  // namespace shabon::app
