// What a scene takes from outside: media, lamps, reflectances and pictures. This room opens no files; the caller says
// how they are found.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/spectrum.h"
#include "shabon/io/image.h"
#include "shabon/math/raster.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::scene {

// A picture as its file holds it.
struct TextureFile {
  math::Raster raster;         // one channel, or three: red, green and blue
  bool whole_numbers = false;  // PNG, JPEG: 0..1 of the largest number, colours encoded as sRGB; else linear, as they stand
  int bits = 0;                // of whole numbers
  int negatives = 0;           // values that were below zero and became 0
};

template <class T>
Result<T> no_file(const std::string& file) {
  return fail(Failure::content, "this scene may not name files, got '" + file + "'");
}

struct Resources {
  // Finds media by name, or n-k files by the path written in the scene (relative to the scene file).
  optics::MediumResolver medium = optics::resolve_from_library;

  // Finds lamps by what the scene says: a name, a computed lamp, or `file:PATH` (relative to the scene file).
  std::function<Result<color::Illuminant>(std::string_view text)> illuminant = color::illuminant_named;

  // Loads the picture written in the scene (relative to the scene file).
  std::function<Result<io::RgbImage>(const std::string& file)> picture = no_file<io::RgbImage>;

  // Loads the texture written in the scene (relative to the scene file).
  std::function<Result<TextureFile>(const std::string& file)> texture = no_file<TextureFile>;

  // Reads a table of a reflectance over the wavelength (relative to the scene file); 0..1 at 1 nm.
  std::function<Result<color::Spectrum>(const std::string& file)> reflectance = no_file<color::Spectrum>;
};

}  // namespace shabon::scene
