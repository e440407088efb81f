// The table of `shabon spectrum` as a drawing.
#pragma once

#include <string>

#include "spectrum_table.h"

namespace shabon::app {

// Lines over the wavelength, one set for each angle; over the angle when there is a single wavelength. Shares,
// absorption per layer, amplitudes and angles have a plot each.
std::string spectrum_svg(const SpectrumTable& table);

}  // namespace shabon::app
