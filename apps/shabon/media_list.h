// The library of media as `shabon media` lists it.
#pragma once

#include <string>

#include "shabon/optics/medium.h"

namespace shabon::app {

std::string media_list_text();
std::string media_list_csv();
std::string media_list_json();

// "182..1129 nm", or "all wavelengths".
std::string range_text(const optics::Medium& medium);
// [182, 1129], or null.
std::string range_json(const optics::Medium& medium);

}  // namespace shabon::app
