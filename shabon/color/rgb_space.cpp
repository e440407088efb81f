#include "shabon/color/rgb_space.h"

#include <cmath>

namespace shabon::color {

namespace {

// ITU-R BT.2020-2, table 4: alpha and beta make the two parts meet with one slope; to the digits of a double they solve
// beta = (alpha - 1)/5.5 and alpha beta^0.45 - (alpha - 1) = 4.5 beta. The recommendation prints 1.0993 and 0.0181.
constexpr double bt2020_alpha = 1.09929682680944, bt2020_beta = 0.018053968510807;
constexpr double bt2020_slope = 4.5, bt2020_exponent = 0.45;

}  // namespace

double encode_srgb_unclipped(double light) { return std::copysign(srgb_curve(std::abs(light)), light); }
double decode_srgb_unclipped(double value) { return std::copysign(srgb_curve_inverse(std::abs(value)), value); }

double encode_bt2020(double light) {
  const double e = std::abs(light);
  const double value =
      e < bt2020_beta ? bt2020_slope * e : bt2020_alpha * std::pow(e, bt2020_exponent) - (bt2020_alpha - 1);
  return std::copysign(value, light);
}

double decode_bt2020(double value) {
  const double v = std::abs(value);
  const double light = v < bt2020_slope * bt2020_beta
                           ? v / bt2020_slope
                           : std::pow((v + (bt2020_alpha - 1)) / bt2020_alpha, 1 / bt2020_exponent);
  return std::copysign(light, value);
}

}  // namespace shabon::color
