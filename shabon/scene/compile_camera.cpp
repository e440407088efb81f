#include "shabon/scene/compile_camera.h"

#include "shabon/base/text.h"
#include "shabon/base/units.h"

namespace shabon::scene {

namespace {

double radians(double degrees) { return Radians(Degrees(degrees)).value; }

Camera projected(const CameraDesc& camera, const ImageDesc& image) {
  Projection projection = projections[0].projection;
  for (const ProjectionEntry& entry : projections)
    if (same_name(entry.name, camera.projection)) projection = entry.projection;
  switch (projection) {
    case Projection::perspective:
      break;
    case Projection::orthographic:
      return orthographic_camera(camera.position, camera.target(), camera.up,
                                 camera.orthographic_height.value_or(default_orthographic_height), image.width,
                                 image.height);
    case Projection::panorama:
      return panorama_camera(camera.position, camera.target(), camera.up, image.width, image.height);
  }
  return look_at_camera(camera.position, camera.target(), camera.up,
                        radians(camera.vertical_fov_deg.value_or(default_vertical_fov_deg)), image.width, image.height);
}

}  // namespace

Camera compile_camera(const CameraDesc& camera, const ImageDesc& image) {
  Camera result = projected(camera, image);
  result.lens_radius = camera.lens_radius;
  result.focus_distance = camera.focus_distance.value_or(result.focus_distance);
  if (camera.polarizer_deg) result.polarizer_rad = radians(*camera.polarizer_deg);
  return result;
}

PixelFilter compile_filter(const ImageDesc& image) {
  for (const FilterEntry& entry : pixel_filters)
    if (same_name(entry.name, image.pixel_filter)) return PixelFilter(entry.kind, image.filter_width_px);
  return {};
}

Development compile_development(const ImageDesc& image, const Path& path, const Resources& resources,
                                Problems& problems) {
  Development result;
  result.exposure_ev = image.exposure_ev;
  const Path place{&path, "white_balance"};
  if (problems.has(place)) return result;
  const Result<color::Illuminant> lamp = resources.illuminant(image.white_balance);
  if (!lamp) {
    for (const Diagnostic& error : lamp.errors()) problems.add_from_file(place, error);
    return result;
  }
  result.white_lamp = lamp->name;
  if (!lamp->note.empty()) problems.add_warning(place, lamp->note);
  const auto balance = white_balance_for(*lamp);
  if (balance)
    result.white_balance = *balance;
  else
    problems.add(place, balance.errors().front().message);
  return result;
}

}  // namespace shabon::scene
