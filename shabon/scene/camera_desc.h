// The picture and the camera, as a scene file states them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/math/vec.h"
#include "shabon/scene/path.h"
#include "shabon/scene/problems.h"
#include "shabon/scene/ranges.h"

namespace shabon::scene {

struct ImageDesc {
  int width = 800, height = 600;
  std::string pixel_filter = "box";
  std::optional<double> filter_width_px = {};  // by default the filter's own
  double exposure_ev = 0;
  std::string white_balance = "D65";
};

inline constexpr double default_vertical_fov_deg = 30, default_orthographic_height = 2;

struct CameraDesc {
  math::Vec3d position{0, 0, 5}, up{0, 1, 0};
  std::optional<math::Vec3d> look_at = {};
  std::string projection = "perspective";
  std::optional<double> vertical_fov_deg = {};     // full angle; perspective only
  std::optional<double> orthographic_height = {};  // orthographic only
  double lens_radius = 0;
  std::optional<double> focus_distance = {};  // by default to look_at
  std::optional<double> polarizer_deg = {};

  // look_at, or what stands for it: the origin; of panoramas, which see all around, a point along -z (along x where up
  // leads along z).
  math::Vec3d target() const;
};

std::vector<std::string_view> projection_names();
std::vector<std::string_view> pixel_filter_names();

constexpr auto fields(Of<ImageDesc>) {
  return std::tuple{
      Field{"width", &ImageDesc::width, {.unit = "pixels", .range = side_range, .doc = "width of the picture"}},
      Field{"height",
            &ImageDesc::height,
            {.unit = "pixels", .range = side_range, .doc = "height; width times height at most 2^28"}},
      Field{"pixel_filter",
            &ImageDesc::pixel_filter,
            {.names = pixel_filter_names, .doc = "how much the points around a pixel's middle count for it"}},
      Field{"filter_width_px",
            &ImageDesc::filter_width_px,
            {.unit = "pixels",
             .range = filter_width_range,
             .unset = "box 1, tent 2, gaussian 3, blackman-harris 3.3",
             .doc = "whole width of the filter"}},
      Field{"exposure_ev",
            &ImageDesc::exposure_ev,
            {.unit = "EV", .range = exposure_range, .doc = "PNG only: brighter by 2 to this power; `--exposure` adds"}},
      Field{"white_balance",
            &ImageDesc::white_balance,
            {.doc = "PNG only: the lamp whose white comes out as white, (44); names as for `illuminant`"}}};
}

constexpr auto fields(Of<CameraDesc>) {
  return std::tuple{
      Field{"position", &CameraDesc::position, {.range = coordinate_range, .doc = "where the camera stands"}},
      Field{"look_at",
            &CameraDesc::look_at,
            {.range = coordinate_range,
             .unset = "[0, 0, 0]; of panoramas along -z, or along x where up is along z",
             .doc = "the point in the middle of the picture"}},
      Field{"up", &CameraDesc::up, {.range = coordinate_range, .doc = "upwards in the picture; not along the view"}},
      Field{"projection",
            &CameraDesc::projection,
            {.names = projection_names, .doc = "how the scene is laid onto the picture"}},
      Field{"vertical_fov_deg",
            &CameraDesc::vertical_fov_deg,
            {.unit = "degrees",
             .range = below_half_turn_deg,
             .unset = "30",
             .doc = "perspective: full vertical angle of view"}},
      Field{"orthographic_height",
            &CameraDesc::orthographic_height,
            {.range = radius_range, .unset = "2", .doc = "orthographic: how much of the scene the height shows"}},
      Field{"lens_radius",
            &CameraDesc::lens_radius,
            {.range = lens_range, .doc = "of a thin lens, not for panoramas; 0 is a pinhole, everything is sharp"}},
      Field{"focus_distance",
            &CameraDesc::focus_distance,
            {.range = radius_range,
             .unset = "that of look_at",
             .doc = "from the position along the view to the plane that is sharp"}},
      Field{"polarizer_deg",
            &CameraDesc::polarizer_deg,
            {.unit = "degrees",
             .range = angle_range_deg,
             .doc = "axis of an ideal linear polariser before the lens, from image right towards image up"}}};
}

void check(const ImageDesc& image, const Path& path, Problems& problems);
void check(const CameraDesc& camera, const Path& path, Problems& problems);

}  // namespace shabon::scene
