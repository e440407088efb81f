#include "shabon/scene/lights/softbox.h"

namespace shabon::scene {

namespace {

// A direction this near to the vertical (a millionth of a radian) has no upright of its own.
constexpr double parallel_sine = 1e-6;

}  // namespace

RoundSoftbox round_softbox(math::Vec3d direction, double half_angle_rad, int channel, double scale) {
  return {math::normalize(direction), std::cos(half_angle_rad), channel, scale};
}

WindowSoftbox window_softbox(math::Vec3d direction, double width_rad, double height_rad, double roll_rad, int channel,
                             double scale) {
  const math::Vec3d axis = math::normalize(direction);
  math::Vec3d sideways = math::cross(axis, math::Vec3d{0, 1, 0});
  if (math::length(sideways) < parallel_sine) sideways = math::cross(axis, math::Vec3d{0, 0, 1});
  const math::Vec3d level = math::normalize(sideways);
  const math::Vec3d upright = math::cross(level, axis);
  const double c = std::cos(roll_rad), s = std::sin(roll_rad);
  return {axis,
          level * c + upright * s,
          upright * c - level * s,
          std::tan(width_rad / 2),
          std::tan(height_rad / 2),
          channel,
          scale};
}

}  // namespace shabon::scene
