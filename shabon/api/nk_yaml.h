// The refractiveindex.info form of an n-k file; see nk_file.h.
#pragma once

#include <filesystem>

#include "shabon/base/result.h"
#include "shabon/optics/medium.h"

namespace shabon::api {

Result<optics::Medium> read_nk_yaml(const std::filesystem::path& path);

}  // namespace shabon::api
