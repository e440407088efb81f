// How the sensor's light becomes a picture for the screen: white balance and exposure. Pictures that hold linear values
// know neither.
#pragma once

#include <optional>
#include <string>

#include "shabon/base/result.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/xyz.h"

namespace shabon::scene {

struct Development {
  double exposure_ev = 0;                       // doubles the light with every 1
  std::string white_lamp = "D65";               // whose white comes out as that of D65
  std::optional<color::Matrix3> white_balance;  // on XYZ, equation (44); none for D65 itself

  color::Xyz balanced(const color::Xyz& colour) const {
    if (!white_balance) return colour;
    const color::Vector3 result = color::multiply(*white_balance, color::Vector3{colour.x, colour.y, colour.z});
    return {result[0], result[1], result[2]};
  }
};

// The white balance for a lamp; nothing for a lamp with the white of D65. Failure::content for a lamp whose colour is
// so saturated that it cannot be taken for white.
Result<std::optional<color::Matrix3>> white_balance_for(const color::Illuminant& lamp);

}  // namespace shabon::scene
