#include "shabon/scene/compile_objects.h"

#include <algorithm>
#include <cmath>

#include "shabon/geometry/coincidence.h"
#include "shabon/scene/bubble_motion.h"
#include "shabon/scene/media_flaws.h"
#include "shabon/scene/object_at.h"
#include "shabon/scene/schema_fields.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

// In scene units. Smaller objects are slips, and their areas would leave the range of numbers.
constexpr double smallest_size = 1e-9;

// The time to compare all pairs grows with their square: beyond so many objects only copies are found.
constexpr std::size_t most_compared = 1000;

math::Vec3d times(const math::Vec3d& a, const math::Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

geometry::PlacedShape placed_as(const geometry::Shape& shape, const PlacementDesc& where, const math::Vec3d& size) {
  return geometry::place(shape, geometry::placement(where.position, where.rotation_deg, times(where.scale, size)));
}

std::string_view name_of(const ObjectDesc& object) {
  return std::visit([](const auto& chosen) { return about(Of<std::decay_t<decltype(chosen)>>{}).name; }, object);
}

// What objects are called in messages.
struct Names {
  const std::vector<ObjectDesc>& objects;
  const Path& path;

  std::string_view shape(int index) const { return name_of(objects[static_cast<std::size_t>(index)]); }
  std::string of(int index) const {
    return path.text() + "[" + std::to_string(index) + "]." + std::string(shape(index));
  }
};

struct Placed {
  geometry::PlacedShape shape;
  int place_in_file;
};

// What is the same for shapes that are copies of one another.
std::array<double, 14> identity_of(const geometry::PlacedShape& placed) {
  double parameter = 0;
  if (const auto* cap = std::get_if<geometry::SphereCap>(&placed.shape)) parameter = cap->cos_cap;
  if (const auto* disk = std::get_if<geometry::Disk>(&placed.shape)) parameter = disk->hole;
  if (const auto* lobed = std::get_if<geometry::LobedSphere>(&placed.shape))
    parameter = geometry::radius_at(*lobed, {0.48, 0.6, 0.64});  // in any direction
  if (const auto* torus = std::get_if<geometry::Torus>(&placed.shape)) parameter = torus->tube;
  const auto& [x, y, z, o] = placed.to_world;
  return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, o.x, o.y, o.z, parameter, double(placed.shape.index())};
}

// The first `object_count` are no bubbles: bubbles on bubbles are met in their order.
void warn_of_coincidence(const std::vector<Placed>& all, std::size_t object_count, const Names& names,
                         Problems& problems) {
  const auto warn = [&](int a, int b) {
    if (a == b) return;  // a bubble that is an object
    const int later = std::max(a, b);
    const Path item{&names.path, {}, later};
    problems.add_warning(Path{&item, names.shape(later)},
                         "lies on " + names.of(std::min(a, b)) + ": which of the two is met first is left to rounding");
  };
  std::map<std::array<double, 14>, int> first_of;
  std::vector<geometry::PlacedShape> different;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [entry, added] = first_of.try_emplace(identity_of(all[i].shape), all[i].place_in_file);
    if (!added) {
      warn(entry->second, all[i].place_in_file);
      continue;
    }
    different.push_back(all[i].shape);
    index.push_back(i);
  }
  if (different.size() > most_compared) return;
  for (const auto& [first, second] : geometry::coincident(different)) {
    const std::size_t a = index[static_cast<std::size_t>(first)], b = index[static_cast<std::size_t>(second)];
    if (a < object_count) warn(all[a].place_in_file, all[b].place_in_file);
  }
}

// `places` are those in the file of the scene's objects, then of its bubbles.
void warn_of_media(const Scene& scene, const std::vector<int>& places, const Names& names, Problems& problems) {
  for (const MediaFlaw& flaw : media_flaws(scene)) {
    const int at = places[static_cast<std::size_t>(flaw.object)];
    const Path item{&names.path, {}, at};
    const std::string side = flaw.behind ? "behind" : "in front of";
    std::string message;
    if (flaw.other)
      message = "the medium " + side + " it is '" + flaw.here.name() + "', but " +
                names.of(places[static_cast<std::size_t>(*flaw.other)]) + ", which is met next there, has '" +
                flaw.there.name() + "' on this side";
    else
      message = "nothing closes the '" + flaw.here.name() + "' " + side +
                " it: light in it leaves the scene. Close it with more surfaces" +
                (flaw.behind ? ", or take a 'pane' for a thin plate" : "");
    problems.add_warning(Path{&item, names.shape(at)}, message);
  }
}

// The extents that matter, each in scene units.
double least_size(const PlacementDesc& where, const math::Vec3d& size) {
  const math::Vec3d extent = times(where.scale, size);
  return std::min({extent.x, extent.y, extent.z});
}
math::Vec3d size_of(const SphereDesc& sphere) { return {sphere.radius, sphere.radius, sphere.radius}; }
math::Vec3d size_of(const QuadDesc& quad) {
  return {quad.width / 2, quad.height / 2, std::sqrt(quad.width / 2) * std::sqrt(quad.height / 2)};
}
math::Vec3d size_of(const DiskDesc& disk) { return {disk.radius, disk.radius, disk.radius}; }
math::Vec3d size_of(const CylinderDesc& tube) { return {tube.radius, tube.height / 2, tube.radius}; }
math::Vec3d size_of(const TorusDesc& torus) { return {torus.radius, torus.radius, torus.radius}; }

template <class ShapeDesc>
bool large_enough(const ShapeDesc& shape, const Path& path, Problems& problems) {
  if constexpr (std::is_base_of_v<PlacementDesc, ShapeDesc>) {
    const double least = least_size(shape, size_of(shape));
    if (!(least >= smallest_size)) {
      problems.add(path, "expected an object of at least " + value_text(smallest_size) + " in each direction, got " +
                             format_number(least, 3));
      return false;
    }
  }
  return true;
}

// Pictures by (u, v) are those by direction on a whole sphere.
void set_by_direction(Film& film) {
  if (!film.thickness_map_nm) return;
  const auto& [raster, repeat_u, repeat_v] = film.thickness_map_nm->picture;
  if (raster != nullptr) film.thickness = film::LatitudeMap{raster, repeat_u, repeat_v};
  film.thickness_map_nm.reset();
}

}  // namespace

geometry::PlacedShape placed(const SphereDesc& sphere) {
  const geometry::SphereCap cap{geometry::turn_by(sphere.cap_deg).cosine};
  return placed_as(cap, sphere, size_of(sphere));
}
geometry::PlacedShape placed(const QuadDesc& quad) { return placed_as(geometry::Quad{}, quad, size_of(quad)); }
geometry::PlacedShape placed(const DiskDesc& disk) {
  return placed_as(geometry::Disk{disk.hole_radius / disk.radius}, disk, size_of(disk));
}
geometry::PlacedShape placed(const CylinderDesc& tube) { return placed_as(geometry::Cylinder{}, tube, size_of(tube)); }
geometry::PlacedShape placed(const TorusDesc& torus) {
  return placed_as(geometry::Torus{torus.tube_radius / torus.radius}, torus, size_of(torus));
}
geometry::PlacedShape placed(const TriangleDesc& triangle) {
  const auto& corners = triangle.corners;
  return geometry::place(geometry::Triangle{}, geometry::triangle_placement(corners[0], corners[1], corners[2]));
}

void ObjectsCompiler::add(const ObjectDesc& object, const Path& path, int index) {
  const Path below{&path, name_of(object)};
  std::visit([&](const auto& chosen) { add_one(chosen, below, index); }, object);
}

void ObjectsCompiler::add_one(const BubbleDesc& bubble, const Path& path, int index) {
  std::optional<Film> film = surfaces_.film(bubble.film, Path{&path, "film"});
  if (!film || problems_.has(Path{&path, "center"}) || problems_.has(Path{&path, "radius"})) return;
  set_by_direction(*film);
  if (!move(bubble, *film, path)) return;
  if (!bubble.modes.empty()) return add_trembling(bubble, *std::move(film), path, index);
  // -0 + 0 = 0: the two zeros are one place.
  const std::array<double, 4> key = {bubble.center.x + 0.0, bubble.center.y + 0.0, bubble.center.z + 0.0,
                                     bubble.radius};
  const auto [entry, added] = bubble_at_.try_emplace(key, bubbles_.size());
  if (added) bubbles_.push_back({{bubble.center, bubble.radius, 0, 0, index}, {}});
  bubbles_[entry->second].films.push_back(*std::move(film));
}

void ObjectsCompiler::add_trembling(const BubbleDesc& bubble, Film film, const Path& path, int index) {
  const auto body = body_of(bubble, film, scene_.metres_per_unit, 0, path, problems_);
  if (!body || !check_modes(bubble.modes, *body, path, problems_)) return;
  const double r = bubble.radius;
  const geometry::Affine place = geometry::placement(bubble.center, {0, 0, 0}, {r, r, r});
  scene_.surfaces.push_back(FreeFilmSurface{surfaces_.add_film(std::move(film)), 1});
  scene_.objects.push_back({geometry::place(trembling(bubble.modes, *body, scene_.time_s), place),
                            static_cast<int>(scene_.surfaces.size()) - 1, index});
}

template <class ShapeDesc>
void ObjectsCompiler::add_one(const ShapeDesc& shape, const Path& path, int index) {
  const std::optional<int> surface = surfaces_.add(shape.surface, Path{&path, "surface"});
  for (const Path& part : {Path{&path, "radius"},
                           {&path, "width"},
                           {&path, "height"},
                           {&path, "hole_radius"},
                           {&path, "tube_radius"},
                           {&path, "corners"},
                           {&path, "position"},
                           {&path, "rotation_deg"},
                           {&path, "scale"},
                           {&path, "cap_deg"}})
    if (problems_.has(part)) return;
  if (!large_enough(shape, path, problems_) || !surface) return;
  scene_.objects.push_back({placed(shape), *surface, index});
}

// Whether the film is there at the scene's time, with the hole it has then.
bool ObjectsCompiler::move(const BubbleDesc& bubble, Film& film, const Path& path) {
  const auto& popping = bubble.popping;
  if (popping && (!check_popping(film, path, problems_) || problems_.has(Path{&path, "popping"}))) return true;
  if (!popping && !film.flow) return true;
  const double from_s = popping ? popping->start_s : 0;
  const auto body = body_of(bubble, film, scene_.metres_per_unit, from_s, path, problems_);
  if (!body) return true;
  if (film.flow) {
    film.bursting = bursting_of(bubble, film, *body);
    return true;
  }
  const film::Hole hole = film::hole_at(*body, *popping, scene_.time_s);
  open_hole(film, hole, *body, popping->from_centre);
  return hole.angle_rad < std::numbers::pi;
}

void ObjectsCompiler::keep(Bubble& bubble) {
  bubble.sphere.first_film = static_cast<int>(scene_.films.size());
  bubble.sphere.film_count = static_cast<int>(bubble.films.size());
  for (Film& film : bubble.films) scene_.films.push_back(std::move(film));
  scene_.spheres.push_back(bubble.sphere);
}

void ObjectsCompiler::finish(const std::vector<ObjectDesc>& objects, const Path& path) {
  for (Bubble& bubble : bubbles_) keep(bubble);
  std::vector<Placed> all;
  for (const Object& object : scene_.objects) all.push_back({object.shape, object.place_in_file});
  const std::size_t object_count = all.size();
  for (const Bubble& bubble : bubbles_) {
    SphereDesc shape;
    shape.position = bubble.sphere.center;
    shape.radius = bubble.sphere.radius;
    all.push_back({placed(shape), bubble.sphere.place_in_file});
  }
  const Names names{objects, path};
  if (object_count > 0) warn_of_coincidence(all, object_count, names, problems_);
  if (!problems_.empty()) return;
  std::vector<int> places;
  for (const Placed& one : all) places.push_back(one.place_in_file);
  warn_of_media(scene_, places, names, problems_);
}

void ObjectsCompiler::check_camera(const std::vector<ObjectDesc>& objects, const Path& path,
                                   const math::Vec3d& camera) {
  const Path root, camera_path{&root, "camera"}, position{&camera_path, "position"};
  const auto at = object_at(scene_, camera);
  if (at && !problems_.has(position))
    problems_.add(position, "expected a place off every surface, got one on " + Names{objects, path}.of(*at));
}

}  // namespace shabon::scene
