// A colour as a user tells it: '#c8a2ff', 'Lab:60,20,-30'.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/color/spaces.h"
#include "shabon/color/xyz.h"

namespace shabon::app {

struct ToldColor {
  std::string text;
  color::ColorSpace space = color::ColorSpace::sRGB;
  color::Xyz xyz;
  bool is_bytes = false;    // #rrggbb: within sRGB, in steps
  bool at_the_end = false;  // a byte is 0 or 255: perhaps clipped
};

// `white` is that of the lamp, for Lab, LCh and xyY. Failure::usage with what was expected.
Result<ToldColor> told_color(std::string_view text, color::Xyz white);

// The largest CIEDE2000 to a colour that rounds to the same bytes; 0 for other colours. `white` is that of Lab.
double rounding_difference(const ToldColor& told, color::Xyz white);

}  // namespace shabon::app
