// The version of the library, such as "0.1.0".
#pragma once

#include <string_view>

namespace shabon {

std::string_view version();

}  // namespace shabon
