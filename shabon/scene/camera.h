// A pinhole camera with square pixels and, if wanted, a linear polariser before the lens.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "shabon/math/vec.h"

namespace shabon::scene {

struct Camera {
  math::Vec3d position;
  math::Vec3d forward, right, up;  // orthonormal, right = forward x up
  // Image plane at distance 1, one step per pixel; pixel (0, 0) has its corner at the top left.
  math::Vec3d top_left, step_x, step_y;
  std::optional<double> polarizer_rad;  // from image right towards image up

  // The direction, not normalised, through the point (x, y) of the image, counted in pixels from the top left.
  template <class T>
  math::Vec3<T> through(T x, T y) const {
    const auto along = [&](double a, double dx, double dy) { return T(a) + x * T(dx) + y * T(dy); };
    return {along(top_left.x, step_x.x, step_y.x), along(top_left.y, step_x.y, step_y.y),
            along(top_left.z, step_x.z, step_y.z)};
  }
};

// `vertical_fov_rad` is the full angle; `position` and `look_at` must differ and `up` must not be parallel to the view.
inline Camera look_at_camera(math::Vec3d position, math::Vec3d look_at, math::Vec3d up, double vertical_fov_rad,
                             int width, int height) {
  Camera camera;
  camera.position = position;
  camera.forward = math::normalize(look_at - position);
  camera.right = math::normalize(math::cross(camera.forward, up));
  camera.up = math::cross(camera.right, camera.forward);
  const double pixel = 2 * std::tan(vertical_fov_rad / 2) / height;
  camera.step_x = camera.right * pixel;
  camera.step_y = -camera.up * pixel;
  camera.top_left = camera.forward - camera.step_x * (width / 2.0) - camera.step_y * (height / 2.0);
  return camera;
}

}  // namespace shabon::scene
