// A film's thickness by itself, as a scene file states it below `thickness`.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/film/thickness_field.h"
#include "shabon/scene/resources.h"

namespace shabon::scene {

// The film that the text states ("linear: {top_nm: 150, bottom_nm: 900}"), over the directions of a sphere, at each of
// these times. `source` is the name shown in errors. Errors (Failure::content): everything that is wrong, each at its
// place; a simulated film, which has no thickness before it runs; those of `resources` for maps. Warnings, if wanted,
// are added to `warnings`.
Result<std::vector<film::ThicknessField>> read_thickness(std::string_view text, std::string source,
                                                         std::span<const double> times_s, const Resources& resources,
                                                         Diagnostics* warnings = nullptr);

}  // namespace shabon::scene
