// A rectangle as a point sees it, and directions uniform over that (C. Urena, M. Fajardo and A. King, "An
// area-preserving parametrization for spherical rectangles", Computer Graphics Forum 32 (2013) 4).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/math/vec.h"

namespace shabon::geometry {

class SphericalRectangle {
 public:
  // `half_x` and `half_y` are at right angles and lead from the centre to the middles of two edges.
  SphericalRectangle(math::Vec3d to_centre, math::Vec3d half_x, math::Vec3d half_y) {
    const double width = math::length(half_x), height = math::length(half_y);
    x_ = half_x * (1 / width), y_ = half_y * (1 / height), z_ = cross(x_, y_);
    z0_ = dot(to_centre, z_);
    if (z0_ > 0) z_ = -z_, z0_ = -z0_;
    const double x = dot(to_centre, x_), y = dot(to_centre, y_);
    x0_ = x - width, x1_ = x + width, y0_ = y - height, y1_ = y + height;
    const double g2 = corner(x0_, y1_), g3 = corner(-x0_, y0_);
    rest_ = 2 * std::numbers::pi - g2 - g3;
    solid_angle_ = corner(x1_, y0_) + corner(-x1_, y1_) - rest_;
    b0_ = -y0_ / std::hypot(y0_, z0_), b1_ = y1_ / std::hypot(y1_, z0_);
  }

  // The distance from the rectangle's plane. On it there is nothing to be seen, and all else is undefined.
  double above() const { return -z0_; }

  // In steradians, to about 1e-15.
  double solid_angle() const { return solid_angle_; }

  // The point of the rectangle, from the one that sees it, in a direction that is uniform over it; u in [0, 1).
  math::Vec3d sample(double u1, double u2) const {
    const double angle = u1 * solid_angle_ + rest_;
    const double f = (std::cos(angle) * b0_ - b1_) / std::sin(angle);
    const double x = -z0_ * std::copysign(1 / std::sqrt(std::max(0.0, f * f + b0_ * b0_ - 1)), f);
    const double across = std::clamp(x, x0_, x1_);  // also where it is infinite
    const double d2 = across * across + z0_ * z0_;
    const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
    const double h = h0 + u2 * (h1 - h0), rest = 1 - h * h;
    const double y = rest > 0 ? std::clamp(h * std::sqrt(d2 / rest), y0_, y1_) : y1_;
    return x_ * across + y_ * y + z_ * z0_;
  }

 private:
  // The inner angle of the spherical polygon at a corner, without cancellation.
  double corner(double x, double y) const { return std::atan2(-z0_ * std::sqrt(x * x + y * y + z0_ * z0_), x * y); }

  math::Vec3d x_, y_, z_;  // from the point, z away from the rectangle
  double x0_, x1_, y0_, y1_, z0_;
  double rest_, solid_angle_, b0_, b1_;
};

}  // namespace shabon::geometry
