// The option --wavelengths: a grid A:B:STEP or a list L1,L2,...
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "shabon/base/field.h"

namespace shabon::app {

inline constexpr std::size_t most_wavelengths = 1'000'000;

// The vacuum wavelengths in nm, in the order given. A grid holds A and every A + i STEP up to B, with B itself when the
// steps reach it. Ends with a usage error when one lies outside `range`.
std::vector<double> wavelengths_in(const std::string& option, const std::string& text, Range range);

// Adds the option; `target` holds the default until it is given.
void add_wavelengths(CLI::App& app, std::vector<double>& target, const std::string& default_text, Range range);

}  // namespace shabon::app
