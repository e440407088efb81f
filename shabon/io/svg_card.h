// Colours as cards: a patch with lines of text below it.
#pragma once

#include <string>
#include <vector>

#include "shabon/io/svg.h"

namespace shabon::io {

struct CardPatch {
  std::string heading;
  Rgb8 color{};
  std::vector<std::string> lines;
};

struct ColorCard {
  std::string title, subtitle;
  std::vector<CardPatch> patches;  // up to three side by side
  std::vector<std::string> notes;  // lines at the foot
};

// A complete SVG 1.1 document.
std::string card_svg(const ColorCard& card);

}  // namespace shabon::io
