// Is a picture the golden one, but for its own noise?
#pragma once

#include <array>
#include <string>

#include "shabon/io/image.h"

namespace shabon::test {

struct Comparison {
  double chi_square = 0;               // mean over pixels and channels of (difference / its standard error)^2
  double block_chi_square = 0;         // the same of the means over blocks of pixels: small shifts of many pixels
  std::array<double, 3> mean_error{};  // difference of the picture's mean colour, in standard errors
  double typical_noise = 0;            // root mean square of the standard errors, linear sRGB
  double worst = 0;                    // largest |difference| / standard error
  int worst_x = 0, worst_y = 0;

  bool agrees() const;
  std::string text() const;
};

// `first` and `second` are the same picture from two seeds: their mean is compared with `golden`, and half of their
// difference, pooled over the neighbours of each pixel, is its standard error. All have one size.
Comparison compare(const io::RgbImage& first, const io::RgbImage& second, const io::RgbImage& golden);

}  // namespace shabon::test
