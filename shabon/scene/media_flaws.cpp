#include "shabon/scene/media_flaws.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shabon/geometry/shape_set.h"
#include "shabon/math/normal_to.h"
#include "shabon/scene/film_parts.h"

namespace shabon::scene {

namespace {

constexpr std::size_t most_objects = 20000, most_dielectrics = 1000;
constexpr int lines = 64;       // from each side of an object
constexpr int most_wrong = 6;   // about one in ten: slight overlaps are no flaws
constexpr int most_films = 32;  // on one line

std::vector<geometry::PlacedShape> shapes_of(const Scene& scene) {
  std::vector<geometry::PlacedShape> shapes;
  for (const Object& object : scene.objects) shapes.push_back(object.shape);
  for (const Sphere& s : scene.spheres)
    shapes.push_back(geometry::place(geometry::SphereCap{},
                                     geometry::placement(s.center, {0, 0, 0}, {s.radius, s.radius, s.radius})));
  return shapes;
}

// A line from a point of the surface, away from it on the chosen side; evenly spread over points and directions.
struct Line {
  math::Vec3d origin, direction;
};

double fraction(double x) { return x - std::floor(x); }

Line line_from(const geometry::PlacedShape& shape, bool behind, int index) {
  // Multiples of the powers of the root of x^5 = x + 1 (M. Roberts 2018) fill four dimensions evenly.
  constexpr double root = 1.1673039782614187;
  double u[4], step = 1;
  for (double& number : u) step /= root, number = fraction(0.5 + step * (index + 1));
  const geometry::SurfacePoint at = geometry::sample_area(shape, u[0], u[1]).at;
  const math::Vec3d axis = behind ? -at.normal : at.normal;
  const math::Vec3d x = math::any_normal_to(axis), y = math::cross(axis, x);
  const double r = std::sqrt(u[2]), phi = 2 * std::numbers::pi * u[3];
  return {at.position, math::normalize(x * (r * std::cos(phi)) + y * (r * std::sin(phi)) + axis * std::sqrt(1 - u[2]))};
}

// The medium on the side of the surface that a line arrives at; nothing where any will do.
struct FacingMedium {
  bool from_back;
  std::optional<optics::Medium> operator()(const DielectricSurface& s) const {
    return outer_medium(from_back ? s.coating.stack.exit : s.coating.stack.incidence);
  }
  std::optional<optics::Medium> operator()(const ConductorSurface& s) const {
    return outer_medium(s.coating.stack.incidence);
  }
  std::optional<optics::Medium> operator()(const GlossySurface& s) const {
    return outer_medium(s.coating.stack.incidence);
  }
  template <class Other>
  std::optional<optics::Medium> operator()(const Other&) const {
    return {};
  }
};

class MediaCheck {
 public:
  explicit MediaCheck(const Scene& scene) : scene_(scene), shapes_(shapes_of(scene)) {
    for (const Object& object : scene.objects)
      if (const auto* solid = std::get_if<DielectricSurface>(&surface_of(object)))
        held_.push_back(outer_medium(solid->coating.stack.exit));
  }

  std::vector<MediaFlaw> flaws() {
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < scene_.objects.size() && looked_at < most_dielectrics; ++i)
      if (const auto* solid = std::get_if<DielectricSurface>(&surface_of(scene_.objects[i]))) {
        ++looked_at;
        look_from(static_cast<int>(i), outer_medium(solid->coating.stack.exit), true);
        look_from(static_cast<int>(i), outer_medium(solid->coating.stack.incidence), false);
      }
    return std::move(flaws_);
  }

 private:
  struct End {
    int object = geometry::no_shape;  // that is met in another medium, or none
    optics::Medium medium;
  };

  const Surface& surface_of(const Object& object) const {
    return scene_.surfaces[static_cast<std::size_t>(object.surface)];
  }

  // Where a line through the medium arrives in another one; nothing where all is well.
  std::optional<End> wrong_end(Line line, int from, const optics::Medium& medium) const {
    for (int met = 0; met < most_films; ++met) {
      const auto hit = shapes_.next(line.origin, line.direction, from);
      if (!hit) return medium == scene_.medium ? std::nullopt : std::optional(End{geometry::no_shape, scene_.medium});
      const auto index = static_cast<std::size_t>(hit->shape);
      const auto at = geometry::surface_at(shapes_.shapes()[index], line.origin, line.direction, hit->distance);
      const Surface* surface = index < scene_.objects.size() ? &surface_of(scene_.objects[index]) : nullptr;
      const bool straight = surface == nullptr || std::holds_alternative<FreeFilmSurface>(*surface) ||
                            std::holds_alternative<PaneSurface>(*surface);
      const bool from_back = math::dot(line.direction, at.normal) > 0;
      const std::optional<optics::Medium> facing =
          straight ? scene_.medium : std::visit(FacingMedium{from_back}, *surface);
      if (facing && !(*facing == medium)) return End{hit->shape, *facing};
      if (!straight) return {};
      line.origin = at.position, from = hit->shape;
    }
    return {};
  }

  void look_from(int object, const optics::Medium& medium, bool behind) {
    std::map<int, std::pair<int, optics::Medium>> wrong;  // number of lines by what they meet
    for (int i = 0; i < lines; ++i)
      if (const auto end =
              wrong_end(line_from(shapes_.shapes()[static_cast<std::size_t>(object)], behind, i), object, medium)) {
        auto& [count, there] = wrong[end->object];
        ++count, there = end->medium;
      }
    for (const auto& [other, found] : wrong) {
      if (found.first <= most_wrong) continue;
      const bool open = other == geometry::no_shape;
      // A medium in front that nothing holds is told elsewhere.
      if (open && !behind && std::find(held_.begin(), held_.end(), medium) == held_.end()) continue;
      if (!open && !told_.insert(std::minmax(object, other)).second) continue;
      flaws_.push_back({object, open ? std::nullopt : std::optional(other), medium, found.second, behind});
    }
  }

  const Scene& scene_;
  geometry::ShapeSet shapes_;
  std::vector<optics::Medium> held_;  // behind dielectrics
  std::set<std::pair<int, int>> told_;
  std::vector<MediaFlaw> flaws_;
};

}  // namespace

std::vector<MediaFlaw> media_flaws(const Scene& scene) {
  const bool any = std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [](const Surface& surface) {
    return std::holds_alternative<DielectricSurface>(surface);
  });
  if (!any || scene.objects.size() + scene.spheres.size() > most_objects) return {};
  return MediaCheck(scene).flaws();
}

}  // namespace shabon::scene
