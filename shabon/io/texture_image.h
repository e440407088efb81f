// Pictures as the numbers in their files, in the depth they have there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/io/image.h"

namespace shabon::io {

struct TextureImage {
  int width = 0, height = 0, channels = 1;  // one channel, or three: red, green and blue
  std::vector<float> values;                // rows from top to bottom, the channels of a pixel side by side
  bool whole_numbers = false;               // PNG, JPEG: 0..1 of the largest number, colours encoded; else linear
  int bits = 0;                             // of whole numbers, as the file has them
  int negatives = 0;                        // how many colour values were below zero in the file and became 0
};

// Grey or colours of 1 to 16 bits as they stand, 0..1 of the largest number; transparency is left out, no gamma is
// applied. Errors as decode_png().
Result<TextureImage> decode_png_texture(std::string_view bytes, const std::string& source);

// Grey or colours of 8 bits as they stand, 0..1; no profile and no orientation is applied. Errors as decode_png(); also
// a picture of inks (CMYK), one with parts missing, and one of more than 500 scans.
Result<TextureImage> decode_jpeg_texture(std::string_view bytes, const std::string& source);

// R, G and B where there are all three, as decode_exr(); else the numbers of Y, of R, or of the only channel. Errors as
// there; a channel of numbers may not be negative (the pixel is named).
Result<TextureImage> decode_exr_texture(std::string_view bytes, const std::string& source);

// PNG, JPEG, OpenEXR or Radiance, told apart by content. Errors as read_image().
Result<TextureImage> read_texture_image(const std::filesystem::path& path);

// Linear colours as a texture.
TextureImage texture_of(RgbImage image);

}  // namespace shabon::io
