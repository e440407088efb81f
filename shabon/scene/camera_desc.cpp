#include "shabon/scene/camera_desc.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/scene/camera.h"
#include "shabon/scene/pixel_filter.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

double length_of(const math::Vec3d& v) { return std::hypot(v.x, v.y, v.z); }

void check_view(const CameraDesc& camera, const Path& path, Problems& problems) {
  const Path position{&path, "position"}, look_at{&path, "look_at"}, upwards{&path, "up"};
  if (problems.has(position) || problems.has(look_at) || problems.has(upwards)) return;
  const math::Vec3d view = camera.target() - camera.position;
  const double coordinates = std::max(1.0, length_of(camera.position));
  if (length_of(view) < shortest_vector * coordinates)
    return problems.add(look_at, "expected a point away from the camera's position, got " +
                                     value_text(camera.target()) + ", which is the position");
  if (length_of(camera.up) < shortest_vector)
    return problems.add(upwards, "expected a direction, got " + value_text(camera.up));
  const math::Vec3d forward = view * (1 / length_of(view)), up = camera.up * (1 / length_of(camera.up));
  if (length_of(math::cross(forward, up)) < parallel_sine)
    problems.add(upwards, "expected a direction that is not parallel to the view, got " + value_text(camera.up));
}

// Keys that mean something in some projections only.
void check_projection(const CameraDesc& camera, const Path& path, Problems& problems) {
  if (problems.has(Path{&path, "projection"})) return;
  struct OwnKey {
    std::string_view key;
    bool given;
    bool (*belongs_to)(const ProjectionEntry&);
  };
  const auto is_perspective = [](const ProjectionEntry& p) { return p.projection == Projection::perspective; };
  const auto is_orthographic = [](const ProjectionEntry& p) { return p.projection == Projection::orthographic; };
  const auto has_lens = [](const ProjectionEntry& p) { return p.has_lens; };
  const OwnKey own_keys[] = {{"vertical_fov_deg", camera.vertical_fov_deg.has_value(), is_perspective},
                             {"orthographic_height", camera.orthographic_height.has_value(), is_orthographic},
                             {"lens_radius", camera.lens_radius > 0, has_lens},
                             {"focus_distance", camera.focus_distance.has_value(), has_lens}};
  for (const OwnKey& own : own_keys) {
    std::string takers;
    bool taken = false;
    for (const ProjectionEntry& entry : projections) {
      if (!own.belongs_to(entry)) continue;
      takers += (takers.empty() ? "" : " or ") + std::string(entry.name);
      taken |= same_name(entry.name, camera.projection);
    }
    const Path place{&path, own.key};
    if (own.given && !taken && !problems.has(place))
      problems.add(place, "expected only where the projection is " + takers + ", not " + lower(camera.projection));
  }
}

}  // namespace

math::Vec3d CameraDesc::target() const {
  if (look_at) return *look_at;
  const auto is_panorama = [](const ProjectionEntry& p) { return p.projection == Projection::panorama; };
  if (!same_name(std::find_if(std::begin(projections), std::end(projections), is_panorama)->name, projection))
    return {0, 0, 0};
  const bool up_along_z = std::hypot(up.x, up.y) < parallel_sine * length_of(up);
  return position + (up_along_z ? math::Vec3d{1, 0, 0} : math::Vec3d{0, 0, -1});
}

std::vector<std::string_view> projection_names() {
  std::vector<std::string_view> names;
  for (const ProjectionEntry& entry : projections) names.push_back(entry.name);
  return names;
}

std::vector<std::string_view> pixel_filter_names() {
  std::vector<std::string_view> names;
  for (const FilterEntry& entry : pixel_filters) names.push_back(entry.name);
  return names;
}

void check(const ImageDesc& image, const Path& path, Problems& problems) {
  const Path lamp{&path, "white_balance"};
  // A file is read when the scene is compiled.
  if (!problems.has(lamp) && !color::illuminant_file(image.white_balance))
    if (const auto found = color::illuminant_named(image.white_balance); !found)
      problems.add(lamp, found.errors().front().message);
  if (problems.has(Path{&path, "width"}) || problems.has(Path{&path, "height"})) return;
  const double pixels = double(image.width) * double(image.height);
  if (pixels > most_pixels)
    problems.add(path, "expected at most 2^28 pixels, got " + std::to_string(image.width) + " x " +
                           std::to_string(image.height));
}

void check(const CameraDesc& camera, const Path& path, Problems& problems) {
  check_view(camera, path, problems);
  check_projection(camera, path, problems);
}

}  // namespace shabon::scene
