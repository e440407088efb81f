// The radius of a lobed sphere with its slopes, for all who ask for more than the radius.
#pragma once

#include "shabon/geometry/shapes/lobed_sphere.h"

namespace shabon::geometry {

// A Legendre polynomial and its derivatives, by the recurrences (n+1) P' = (2n+1) x P - n P and P'(n+1) = P'(n-1) +
// (2n+1) P(n).
struct Legendre {
  double value, slope, bend;
};
Legendre legendre(int degree, double x);

// No more than these over all directions. Along a great circle through n the rotation's generator J has <J^2> =
// l(l+1)/2 for the zonal function about n, so that by Cauchy and Schwarz the first derivative of P_l(n . axis) is at
// most the root of that, and the second that itself.
struct LobeBounds {
  double low, high;  // the radius lies between
  double slope;      // of the radius, per radian
  double bend;       // its second derivative along great circles
};
LobeBounds bounds_of(const LobedSphere& lobed);

// The radius and its gradient on the unit sphere, which is at right angles to n.
struct RadiusSlope {
  double radius;
  math::Vec3d gradient;
};
RadiusSlope slope_at(const LobedSphere& lobed, math::Vec3d n);

}  // namespace shabon::geometry
