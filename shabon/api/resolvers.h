// What the lower rooms leave open, answered: media and lamps by name from the
// library, and those of files through io.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "shabon/color/illuminant.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::api {

// For parse_stack() and scene::compile(): names from media_library(), `file:PATH` by read_nk_file(), relative paths
// from `folder`.
optics::MediumResolver medium_resolver(std::filesystem::path folder = {});

// Lamps as a user names them: color::illuminant_named(), and `file:PATH` by read_lamp_file(), relative paths from
// `folder`.
std::function<Result<color::Illuminant>(std::string_view)> illuminant_resolver(std::filesystem::path folder = {});

}  // namespace shabon::api
