// What a scene takes from outside: media, lamps and pictures. This room opens no files; the caller says how they are
// found.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"
#include "shabon/io/image.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::scene {

struct Resources {
  // Finds media by name, or n-k files by the path written in the scene (relative to the scene file).
  optics::MediumResolver medium = optics::resolve_from_library;

  // Finds lamps by what the scene says: a name, a computed lamp, or `file:PATH` (relative to the scene file).
  std::function<Result<color::Illuminant>(std::string_view text)> illuminant = color::illuminant_named;

  // Loads the picture written in the scene (relative to the scene file).
  std::function<Result<io::RgbImage>(const std::string& file)> picture = [](const std::string& file) {
    return Result<io::RgbImage>(fail(Failure::content, "this scene may not name files, got '" + file + "'"));
  };
};

}  // namespace shabon::scene
