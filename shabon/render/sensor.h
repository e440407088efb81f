// The sensor: what the camera has collected so far, XYZ sums and sample counts per pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "shabon/color/xyz.h"

namespace shabon::render {

class Sensor {
 public:
  struct Pixel {
    double x = 0, y = 0, z = 0;  // sums over the pixel's samples; Y of a lamp with scale 1 is 1 per sample
    std::uint32_t samples = 0;
  };

  Sensor(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

  // The mean of the samples; black where there are none.
  color::Xyz mean(int x, int y) const {
    const Pixel& p = at(x, y);
    const double scale = p.samples ? 1.0 / p.samples : 0.0;
    return {p.x * scale, p.y * scale, p.z * scale};
  }

  // The smallest and largest number of samples of any pixel.
  std::pair<std::uint32_t, std::uint32_t> sample_range() const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_, height_;
  std::vector<Pixel> pixels_;
};

}  // namespace shabon::render
