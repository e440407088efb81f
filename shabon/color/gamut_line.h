// Lines from a grey to a colour in the square roots of Oklab's cone responses, and where they leave the sRGB cube: the
// geometry of equation (20). Internal to gamut mapping.
#pragma once

#include "shabon/color/matrix3.h"

namespace shabon::color {

// Square roots and not Oklab's cube roots: with those the cube hides a sliver of itself behind its blue corner from the
// greys, and no mapping along such lines can be continuous there. The hue of film colours stays within 3 degrees of
// Oklab's (along straight lines in linear light it would be 7.4).
struct RootColor {
  Vector3 roots;        // of the cone responses, with their signs
  double lightness;     // 1 for white
  double a, b, chroma;  // Oklab's second and third row applied to the roots
};

RootColor root_color(const Vector3& linear_srgb);

// The lightness of the strongest colour of sRGB that has the hue of (a, b), not both 0.
double cusp_lightness(double a, double b);

// From the grey of `grey_lightness`, 0 < it < 1, at t = 0 through `colour` at t = 1.
class GamutLine {
 public:
  GamutLine(const RootColor& colour, double grey_lightness);

  // Where it leaves the cube, > 0; infinity if never.
  double exit() const;
  // Linear sRGB, for t up to the exit (the cone responses do not change sign inside the cube).
  Vector3 at(double t) const;

 private:
  double grey_;            // in linear light
  Vector3 slope_, curve_;  // component k is grey + 2 slope[k] t + curve[k] t^2
};

}  // namespace shabon::color
