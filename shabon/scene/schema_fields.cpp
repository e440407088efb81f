#include "shabon/scene/schema_fields.h"

#include <algorithm>
#include <cmath>

#include "shabon/base/text.h"
#include "shabon/color/illuminant.h"
#include "shabon/optics/media.h"
#include "shabon/scene/film_parts.h"
#include "shabon/scene/frames.h"

namespace shabon::scene {

namespace {

double length_of(const math::Vec3d& v) { return std::hypot(v.x, v.y, v.z); }

void check_file_name(const std::string& file, const Path& path, Problems& problems) {
  const Path place{&path, "file"};
  if (!problems.has(place) && file.empty()) problems.add(place, "expected a file name, got an empty text");
}

void check_direction(const math::Vec3d& direction, const Path& place, Problems& problems) {
  if (!problems.has(place) && length_of(direction) < shortest_vector)
    problems.add(place, "expected a direction, got " + value_text(direction));
}

// Files are not read here; a film that names one is checked again when it is compiled.
template <class FilmDescription>
void check_film(const FilmDescription& film, const Path& path, Problems& problems) {
  bool names_file = false;
  const auto parts = film_parts(
      film, path,
      [&](std::string_view name, bool is_file) -> Result<optics::Medium> {
        if (!is_file) return optics::medium_named(name);
        names_file = true;
        return optics::Medium();
      },
      problems);
  if (parts && !names_file) check_outer_media(parts->outside, parts->inside, Path{&path, "stack"}, problems);
}

}  // namespace

const Mapping& scene_schema() { return mapping_of<SceneDesc>(); }

// A file is read when the scene is compiled.
void check(const LampDesc& lamp, const Path& path, Problems& problems) {
  const Path illuminant{&path, "illuminant"};
  if (problems.has(illuminant) || color::illuminant_file(lamp.illuminant)) return;
  if (const auto found = color::illuminant_named(lamp.illuminant); !found)
    problems.add(illuminant, found.errors().front().message);
}

void check(const SoftboxDesc& softbox, const Path& path, Problems& problems) {
  check(static_cast<const LampDesc&>(softbox), path, problems);
  check_direction(softbox.direction, Path{&path, "direction"}, problems);
}

void check(const film::ShapeMode& mode, const Path& path, Problems& problems) {
  check_direction(mode.axis, Path{&path, "axis"}, problems);
}
void check(const film::PoppingDesc& popping, const Path& path, Problems& problems) {
  check_direction(popping.from_centre, Path{&path, "from_centre"}, problems);
}

void check(const ImageEnvironmentDesc& environment, const Path& path, Problems& problems) {
  check_file_name(environment.file, path, problems);
}

void check(const MediumFilmDesc& film, const Path& path, Problems& problems) { check_film(film, path, problems); }
void check(const StackFilmDesc& film, const Path& path, Problems& problems) { check_film(film, path, problems); }

void check(const NumberMapDesc& map, const Path& path, Problems& problems) {
  check_file_name(map.file, path, problems);
}
void check(const ColorMapDesc& map, const Path& path, Problems& problems) { check_file_name(map.file, path, problems); }
std::vector<std::string_view> map_layouts() { return {"surface", "cube"}; }

void check(const ThicknessMapDesc& map, const Path& path, Problems& problems) {
  check_file_name(map.file, path, problems);
  if (problems.has(path)) return;
  if (map.low_nm.has_value() != map.high_nm.has_value())
    problems.add(path, "expected both of 'low_nm' and 'high_nm', or none, got one");
  if (same_name(map.layout, "cube") && map.repeat != Repeat{})
    problems.add(Path{&path, "repeat"}, "cannot stand beside 'layout: cube', whose faces are there once");
  if (!numbered(map.file) && (map.first_frame || map.last_frame || map.frames_per_second))
    problems.add(Path{&path, "file"}, "expected '#' in the name of the file where the frame's number stands, got '" +
                                          map.file + "' beside keys that speak of frames");
  if (map.last_frame && *map.last_frame < map.first_frame.value_or(0))
    problems.add(Path{&path, "last_frame"}, "expected no less than the first frame " +
                                                std::to_string(map.first_frame.value_or(0)) + ", got " +
                                                std::to_string(*map.last_frame));
}

void check(const DiskDesc& disk, const Path& path, Problems& problems) {
  const Path hole{&path, "hole_radius"};
  if (!problems.has(hole) && !problems.has(Path{&path, "radius"}) && disk.hole_radius >= disk.radius)
    problems.add(hole,
                 "expected less than the radius " + value_text(disk.radius) + ", got " + value_text(disk.hole_radius));
}

void check(const TorusDesc& torus, const Path& path, Problems& problems) {
  const Path tube{&path, "tube_radius"};
  if (!problems.has(tube) && !problems.has(Path{&path, "radius"}) && torus.tube_radius >= torus.radius)
    problems.add(
        tube, "expected less than the radius " + value_text(torus.radius) + ", got " + value_text(torus.tube_radius));
}

void check(const TriangleDesc& triangle, const Path& path, Problems& problems) {
  const Path corners{&path, "corners"};
  if (problems.has(corners)) return;
  const math::Vec3d &a = triangle.corners[0], &b = triangle.corners[1], &c = triangle.corners[2];
  const double longest = std::max({length_of(b - a), length_of(c - b), length_of(a - c)});
  const double across = length_of(math::cross(b - a, c - a));  // twice the area
  if (!(across > parallel_sine * longest * longest))
    problems.add(corners, "expected three corners that are not on one line, got " + value_text(a) + ", " +
                              value_text(b) + " and " + value_text(c));
}

std::vector<std::string_view> transport_names() { return {"tree", "path"}; }

void check(const SceneDesc& scene, const Path& path, Problems& problems) {
  const bool averaged = scene.render.interference == optics::Interference::two_beam;
  if (scene.camera.polarizer_deg && averaged) {
    const Path camera{&path, "camera"};
    problems.add_warning(
        Path{&camera, "polarizer_deg"},
        "the two-beam model averages over polarisation at each wall: a polariser only halves the light");
  }
}

}  // namespace shabon::scene
