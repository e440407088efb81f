// What the library of media holds.
#pragma once

#include <vector>

#include "shabon/optics/media.h"

namespace shabon::optics {

std::vector<MediumEntry> make_media_list();

}  // namespace shabon::optics
