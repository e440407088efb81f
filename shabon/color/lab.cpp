#include "shabon/color/lab.h"

#include <cmath>

namespace shabon::color {

namespace {

constexpr double epsilon = 216.0 / 24389;  // (6/29)^3, where the cube root gives way to a straight line
constexpr double kappa = 24389.0 / 27;     // (29/3)^3, the slope of L* there

double lab_function(double t) { return t > epsilon ? std::cbrt(t) : (kappa * t + 16) / 116; }

double lab_inverse(double f) {
  const double cube = f * f * f;
  return cube > epsilon ? cube : (116 * f - 16) / kappa;
}

}  // namespace

Lab xyz_to_lab(Xyz colour, Xyz white) {
  const double fx = lab_function(colour.x / white.x);
  const double fy = lab_function(colour.y / white.y);
  const double fz = lab_function(colour.z / white.z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Xyz lab_to_xyz(Lab colour, Xyz white) {
  const double fy = (colour.L + 16) / 116;
  return {white.x * lab_inverse(fy + colour.a / 500), white.y * lab_inverse(fy),
          white.z * lab_inverse(fy - colour.b / 200)};
}

}  // namespace shabon::color
