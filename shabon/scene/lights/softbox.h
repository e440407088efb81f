// A lamp at infinity with sharp edges: a disk of directions, or the rectangle of a flat window seen from the origin.
#pragma once

#include <cmath>
#include <variant>

#include "shabon/math/vec.h"
#include "shabon/scene/lights/select.h"

namespace shabon::scene {

// All directions within `half_angle` of the axis.
struct RoundSoftbox {
  math::Vec3d axis;  // towards the lamp, unit length
  double cos_half_angle = 1;
  int channel = 0;
  double scale = 1;

  template <class T>
  void add(const math::Vec3<T>& direction, T* coefficients) const {
    const T inside = select(chord_squared(direction) <= T(rim_chord_squared()), T(scale), T(0));
    coefficients[channel] = coefficients[channel] + inside;
  }

  // Chords keep the digits that cosines of small angles lose: the sun's rim is where it is, in float too.
  template <class T>
  T chord_squared(const math::Vec3<T>& direction) const {
    const T x = direction.x - T(axis.x), y = direction.y - T(axis.y), z = direction.z - T(axis.z);
    return x * x + y * y + z * z;
  }
  double rim_chord_squared() const { return 2 * (1 - cos_half_angle); }
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
