#include "shabon/api/version.h"

namespace shabon {

std::string_view version() { return SHABON_VERSION; }

}  // namespace shabon
