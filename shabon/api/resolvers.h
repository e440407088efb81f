// What the lower rooms leave open, answered: media by name from the library, media of n-k files through io.
#pragma once

#include <filesystem>

#include "shabon/optics/stack_expression.h"

namespace shabon::api {

// For parse_stack() and scene::compile(): names from media_library(), `file:PATH` by read_nk_file(), relative paths
// from `folder`.
optics::MediumResolver medium_resolver(std::filesystem::path folder = {});

}  // namespace shabon::api
