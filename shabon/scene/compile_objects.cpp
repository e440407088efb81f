#include "shabon/scene/compile_objects.h"

#include <algorithm>
#include <cmath>

#include "shabon/geometry/coincidence.h"
#include "shabon/scene/schema_fields.h"
#include "shabon/scene/value.h"

namespace shabon::scene {

namespace {

// In scene units. Smaller objects are slips, and their areas would leave the range of numbers.
constexpr double smallest_size = 1e-9;

// In units of the object's size: nearer to it than this, the camera stands on it.
constexpr double on_surface_tolerance = 1e-9;

math::Vec3d times(const math::Vec3d& a, const math::Vec3d& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

geometry::PlacedShape placed_as(const geometry::Shape& shape, const PlacementDesc& where, const math::Vec3d& size) {
  return geometry::place(shape, geometry::placement(where.position, where.rotation_deg, times(where.scale, size)));
}

// In the shape's own coordinates.
bool is_on(const geometry::SphereCap& cap, const math::Vec3d& p, double tolerance) {
  return std::abs(math::length(p) - 1) <= tolerance && p.y >= cap.cos_cap - tolerance;
}
bool is_on(const geometry::Quad&, const math::Vec3d& p, double tolerance) {
  return std::abs(p.z) <= tolerance && std::max(std::abs(p.x), std::abs(p.y)) <= 1 + tolerance;
}
bool is_on(const geometry::Disk& disk, const math::Vec3d& p, double tolerance) {
  const double r = std::hypot(p.x, p.y);
  return std::abs(p.z) <= tolerance && r <= 1 + tolerance && r >= disk.hole - tolerance;
}
bool is_on(const geometry::Cylinder&, const math::Vec3d& p, double tolerance) {
  return std::abs(std::hypot(p.x, p.z) - 1) <= tolerance && std::abs(p.y) <= 1 + tolerance;
}
bool is_on(const geometry::Triangle&, const math::Vec3d& p, double tolerance) {
  return std::abs(p.z) <= tolerance && std::min(p.x, p.y) >= -tolerance && p.x + p.y <= 1 + tolerance;
}

bool stands_on(const geometry::PlacedShape& placed, const math::Vec3d& point) {
  const math::Vec3d p = geometry::apply_point(placed.to_object, point);
  return std::visit([&](const auto& shape) { return is_on(shape, p, on_surface_tolerance); }, placed.shape);
}

bool stands_on(const Sphere& sphere, const math::Vec3d& point) {
  const double distance = math::length(point - sphere.center);
  return std::abs(distance - sphere.radius) <= on_surface_tolerance * sphere.radius;
}

std::string_view name_of(const ObjectDesc& object) {
  return std::visit([](const auto& chosen) { return about(Of<std::decay_t<decltype(chosen)>>{}).name; }, object);
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

template <class ShapeDesc>
bool large_enough(const ShapeDesc& shape, const Path& path, Problems& problems) {
  if constexpr (std::is_base_of_v<PlacementDesc, ShapeDesc>) {
    const double least = least_size(shape, size_of(shape));
    if (!(least >= smallest_size)) {
      problems.add(path, "expected an object of at least " + value_text(smallest_size) + " in each direction, got " +
                             value_text(least));
      return false;
    }
  }
  return true;
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
  // -0 + 0 = 0: the two zeros are one place.
  const std::array<double, 4> key = {bubble.center.x + 0.0, bubble.center.y + 0.0, bubble.center.z + 0.0,
                                     bubble.radius};
  const auto [entry, added] = bubble_at_.try_emplace(key, bubbles_.size());
  if (added) bubbles_.push_back({{bubble.center, bubble.radius, 0, 0}, index, {}});
  bubbles_[entry->second].films.push_back(*std::move(film));
}

template <class ShapeDesc>
void ObjectsCompiler::add_one(const ShapeDesc& shape, const Path& path, int index) {
  const std::optional<int> surface = surfaces_.add(shape.surface, Path{&path, "surface"});
  for (const Path& part : {Path{&path, "radius"},
                           {&path, "width"},
                           {&path, "height"},
                           {&path, "hole_radius"},
                           {&path, "corners"},
                           {&path, "position"},
                           {&path, "rotation_deg"},
                           {&path, "scale"},
                           {&path, "cap_deg"}})
    if (problems_.has(part)) return;
  if (!large_enough(shape, path, problems_) || !surface) return;
  scene_.objects.push_back({placed(shape), *surface, index});
}

// A bubble whose films follow pictures is an object like others.
void ObjectsCompiler::keep(Bubble& bubble) {
  const auto is_map = [](const Film& film) { return film.thickness_map_nm.has_value(); };
  const bool any_map = std::any_of(bubble.films.begin(), bubble.films.end(), is_map);
  const int first = static_cast<int>(scene_.films.size()), count = static_cast<int>(bubble.films.size());
  for (Film& film : bubble.films) scene_.films.push_back(std::move(film));
  bubble.sphere.first_film = first;
  bubble.sphere.film_count = count;
  if (!any_map) return scene_.spheres.push_back(bubble.sphere);
  SphereDesc shape;
  shape.position = bubble.sphere.center;
  shape.radius = bubble.sphere.radius;
  scene_.surfaces.push_back(FreeFilmSurface{first, count});
  scene_.objects.push_back({placed(shape), static_cast<int>(scene_.surfaces.size()) - 1, bubble.place_in_file});
}

void ObjectsCompiler::finish(const std::vector<ObjectDesc>& objects, const Path& objects_path,
                             const math::Vec3d& camera) {
  for (Bubble& bubble : bubbles_) keep(bubble);
  const auto described = [&](int index) {
    return objects_path.text() + "[" + std::to_string(index) + "]." +
           std::string(name_of(objects[static_cast<std::size_t>(index)]));
  };
  const Path root, camera_path{&root, "camera"}, position{&camera_path, "position"};
  const auto refuse_camera = [&](int index) {
    if (!problems_.has(position))
      problems_.add(position, "expected a place off every surface, got one on " + described(index));
  };
  for (const Bubble& bubble : bubbles_)
    if (stands_on(bubble.sphere, camera)) refuse_camera(bubble.place_in_file);
  std::vector<geometry::PlacedShape> shapes;
  for (const Object& object : scene_.objects) {
    if (stands_on(object.shape, camera)) refuse_camera(object.place_in_file);
    shapes.push_back(object.shape);
  }
  if (shapes.empty()) return;
  std::vector<int> place_in_file;
  for (const Object& object : scene_.objects) place_in_file.push_back(object.place_in_file);
  const std::size_t object_count = shapes.size();
  for (const Bubble& bubble : bubbles_) {
    SphereDesc shape;
    shape.position = bubble.sphere.center;
    shape.radius = bubble.sphere.radius;
    shapes.push_back(placed(shape));
    place_in_file.push_back(bubble.place_in_file);
  }
  for (const auto& [first, second] : geometry::coincident(shapes)) {
    if (static_cast<std::size_t>(first) >= object_count) continue;  // bubbles on bubbles are met in their order
    const int a = place_in_file[static_cast<std::size_t>(first)], b = place_in_file[static_cast<std::size_t>(second)];
    if (a == b) continue;  // a bubble that is an object
    const int later = std::max(a, b);
    const Path item{&objects_path, {}, later};
    problems_.add_warning(
        Path{&item, name_of(objects[static_cast<std::size_t>(later)])},
        "lies on " + described(std::min(a, b)) + ": which of the two is met first is left to rounding");
  }
}

}  // namespace shabon::scene
