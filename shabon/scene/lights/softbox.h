// A lamp at infinity with sharp edges: a disk of directions, or the rectangle of a flat window seen from the origin.
#pragma once

#include <cmath>
#include <variant>

#include "shabon/math/vec.h"

namespace shabon::scene {

inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

// All directions within `half_angle` of the axis.
struct RoundSoftbox {
  math::Vec3d axis;  // towards the lamp, unit length
  double cos_half_angle = 1;
  int channel = 0;
  double scale = 1;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    const T cos_off_axis = direction.x * T(axis.x) + direction.y * T(axis.y) + direction.z * T(axis.z);
    const T inside = select(cos_off_axis >= T(cos_half_angle), T(scale), T(0));
    coefficients[channel] = coefficients[channel] + inside;
  }
};

// The directions through a flat rectangle normal to the axis: |x/z| <= tan(width/2), |y/z| <= tan(height/2).
struct WindowSoftbox {
  math::Vec3d axis, right, up;  // orthonormal; right and up span the window
  double tan_half_width = 0, tan_half_height = 0;
  int channel = 0;
  double scale = 1;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    using std::abs;
    const auto along = [&](const math::Vec3d& a) {
      return direction.x * T(a.x) + direction.y * T(a.y) + direction.z * T(a.z);
    };
    const T z = along(axis);
    T inside = select(abs(along(right)) <= z * T(tan_half_width), T(scale), T(0));
    inside = select(abs(along(up)) <= z * T(tan_half_height), inside, T(0));
    coefficients[channel] = coefficients[channel] + inside;
  }
};

using Softbox = std::variant<RoundSoftbox, WindowSoftbox>;

RoundSoftbox round_softbox(math::Vec3d direction, double half_angle_rad, int channel, double scale);

// The window's upright is the world's y (z for a window straight above or below); `roll_rad` turns it
// counter-clockwise as seen from the origin.
WindowSoftbox window_softbox(math::Vec3d direction, double width_rad, double height_rad, double roll_rad, int channel,
                             double scale);

}  // namespace shabon::scene
