// Golden pictures on disk. io::read_exr serves surroundings and takes negative values for 0; film colours outside sRGB
// are negative, so these are read as they are.
#pragma once

#include <filesystem>
#include <optional>

#include "shabon/io/image.h"

namespace shabon::test {

// Empty when it cannot be read.
std::optional<io::RgbImage> read_golden(const std::filesystem::path& path);

}  // namespace shabon::test
