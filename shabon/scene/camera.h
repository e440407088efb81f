// The camera: where the ray of each point of the picture begins and where it goes. Square pixels; a thin lens and a
// linear polariser before it if wanted.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "shabon/math/vec.h"

namespace shabon::scene {

enum class Projection { perspective, orthographic, panorama };

struct ProjectionEntry {
  Projection projection;
  std::string_view name, description;
  bool has_lens;  // one that brings a plane into focus
};

// The closed set; the default first.
inline constexpr ProjectionEntry projections[] = {
    {Projection::perspective, "perspective", "rays from one point; straight lines stay straight", true},
    {Projection::orthographic, "orthographic", "parallel rays; what is far away is as large as what is near", true},
    {Projection::panorama, "panorama", "the whole sphere by longitude and latitude, (25)", false},
};

// A ray away from the eye; the direction has length 1.
struct CameraRay {
  math::Vec3d origin, direction;
};

// A place on the lens, in units of its radius.
struct LensPoint {
  double right = 0, up = 0;
};

// The unit square onto the unit disk, equal areas to equal areas (Shirley and Chiu 1997, "A low distortion map between
// disk and square").
inline LensPoint lens_point(double u1, double u2) {
  const double a = 2 * u1 - 1, b = 2 * u2 - 1;
  if (a == 0 && b == 0) return {};
  const bool wide = std::abs(a) > std::abs(b);
  const double radius = wide ? a : b;
  const double angle = wide ? std::numbers::pi / 4 * (b / a) : std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

struct Camera {
  Projection projection = Projection::perspective;
  math::Vec3d position;
  math::Vec3d forward, right, up;  // orthonormal, right = forward x up
  // One step per pixel; pixel (0, 0) has its corner at the top left. Perspective: directions on the image plane at
  // distance 1. Orthographic: from the position to where rays begin. Of no meaning in a panorama.
  math::Vec3d top_left, step_x, step_y;
  double width_px = 1, height_px = 1;
  double lens_radius = 0;               // 0: everything is sharp
  double focus_distance = 1;            // of the sharp plane, along `forward`
  std::optional<double> polarizer_rad;  // from image right towards image up

  bool has_lens() const { return projection != Projection::panorama && lens_radius > 0; }
  // A point that all rays leave, with directions that through() gives.
  bool is_pinhole() const { return projection == Projection::perspective && !has_lens(); }
  bool rays_begin_in_one_point() const { return projection != Projection::orthographic && !has_lens(); }

  // Of a perspective camera: the direction, not normalised, through the point (x, y) of the image, counted in pixels
  // from the top left.
  template <class T>
  math::Vec3<T> through(T x, T y) const {
    const auto along = [&](double a, double dx, double dy) { return T(a) + x * T(dx) + y * T(dy); };
    return {along(top_left.x, step_x.x, step_y.x), along(top_left.y, step_x.y, step_y.y),
            along(top_left.z, step_x.z, step_y.z)};
  }

  // The ray of the point (x, y) of the image, counted in pixels from the top left, that passes that point of the lens;
  // by default its middle.
  CameraRay ray(double x, double y, LensPoint lens = {}) const {
    switch (projection) {
      case Projection::perspective:
        return through_lens(position, through(x, y), lens);
      case Projection::orthographic:
        return through_lens(position + through(x, y), forward, lens);
      case Projection::panorama:
        break;
    }
    const double azimuth = (x / width_px - 0.5) * 2 * std::numbers::pi, polar = y / height_px * std::numbers::pi;
    const math::Vec3d level = forward * std::cos(azimuth) + right * std::sin(azimuth);
    return {position, math::normalize(level * std::sin(polar) + up * std::cos(polar))};
  }

  // The axis across a ray from which the polariser's angle counts: image right, made normal to the ray. Where a
  // panorama looks along image right itself, image down takes its place.
  math::Vec3d polarizer_right(const math::Vec3d& direction) const {
    constexpr double least_sine = 1e-9;
    const math::Vec3d across = right - direction * math::dot(right, direction);
    return math::length(across) > least_sine ? math::normalize(across) : -up;
  }

 private:
  // All rays of one image point meet in the sharp plane. `ahead` has the length 1 along `forward`.
  CameraRay through_lens(const math::Vec3d& middle, const math::Vec3d& ahead, LensPoint lens) const {
    if (!(lens_radius > 0)) return {middle, math::normalize(ahead)};
    const math::Vec3d aside = right * (lens_radius * lens.right) + up * (lens_radius * lens.up);
    return {middle + aside, math::normalize(ahead * focus_distance - aside)};
  }
};

// A camera without its projection. `position` and `look_at` must differ and `up` must not be parallel to the view. What
// it looks at is in focus.
inline Camera aimed_camera(math::Vec3d position, math::Vec3d look_at, math::Vec3d up, int width, int height) {
  Camera camera;
  camera.position = position;
  camera.forward = math::normalize(look_at - position);
  camera.right = math::normalize(math::cross(camera.forward, up));
  camera.up = math::cross(camera.right, camera.forward);
  camera.width_px = width, camera.height_px = height;
  camera.focus_distance = math::length(look_at - position);
  return camera;
}

// Lays the picture onto a plane: `pixel` is the side of one there, `middle` where the picture's middle lies.
inline void lay_picture(Camera& camera, math::Vec3d middle, double pixel, int width, int height) {
  camera.step_x = camera.right * pixel;
  camera.step_y = -camera.up * pixel;
  camera.top_left = middle - camera.step_x * (width / 2.0) - camera.step_y * (height / 2.0);
}

// `vertical_fov_rad` is the full angle.
inline Camera look_at_camera(math::Vec3d position, math::Vec3d look_at, math::Vec3d up, double vertical_fov_rad,
                             int width, int height) {
  Camera camera = aimed_camera(position, look_at, up, width, height);
  lay_picture(camera, camera.forward, 2 * std::tan(vertical_fov_rad / 2) / height, width, height);
  return camera;
}

// `height_in_units` is that of the picture in the scene. Rays begin on the plane through the position.
inline Camera orthographic_camera(math::Vec3d position, math::Vec3d look_at, math::Vec3d up, double height_in_units,
                                  int width, int height) {
  Camera camera = aimed_camera(position, look_at, up, width, height);
  camera.projection = Projection::orthographic;
  lay_picture(camera, {}, height_in_units / height, width, height);
  return camera;
}

// The middle of the picture looks along the view, its top along the camera's up. Pixels are square where the picture is
// twice as wide as high.
inline Camera panorama_camera(math::Vec3d position, math::Vec3d look_at, math::Vec3d up, int width, int height) {
  Camera camera = aimed_camera(position, look_at, up, width, height);
  camera.projection = Projection::panorama;
  return camera;
}

}  // namespace shabon::scene
