// An SVG drawing as pixels, through librsvg.
#pragma once

#include <string>

#include "shabon/base/result.h"
#include "shabon/io/image.h"

namespace shabon::app {

// The drawing, `width_px` wide, in its own proportions, on white. The letters are those of the fonts that this machine
// has. Errors of Failure::internal: a text that is no SVG, too little memory.
Result<io::Rgb8Image> rasterise(const std::string& svg, int width_px);

}  // namespace shabon::app
