#include "golden_file.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <exception>

namespace shabon::test {

std::optional<io::RgbImage> read_golden(const std::filesystem::path& path) try {
  Imf::InputFile file(path.c_str());
  const auto window = file.header().dataWindow();
  io::RgbImage image;
  image.width = window.max.x - window.min.x + 1, image.height = window.max.y - window.min.y + 1;
  const auto width = static_cast<std::size_t>(image.width);
  image.rgb.resize(3 * width * static_cast<std::size_t>(image.height));
  Imf::FrameBuffer buffer;
  const char* names[] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + c, window, 3 * sizeof(float),
                                             3 * sizeof(float) * width));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
} catch (const std::exception&) {
  return {};
}

}  // namespace shabon::test
