// Patches of colour in a terminal.
#pragma once

#include <string>

#include "shabon/color/rgb.h"

namespace shabon::app {

// Escape codes go to terminals only, unless they are asked for (bixense.com/clicolors) or refused (no-color.org).
bool swatch_wanted();

// Eight blanks on the colour, with two before; whether or not it is wanted.
std::string swatch(color::EncodedRgb colour);

}  // namespace shabon::app
