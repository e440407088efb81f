#include "shabon/geometry/shape.h"

#include "shabon/geometry/sphere.h"

namespace shabon::geometry {

namespace {

using math::Vec3d;

// Maps whose columns are of one length, and at right angles, within this are taken as uniform.
constexpr double uniform_tolerance = 1e-12;
// A flat shape that rises less than this part of its size is level.
constexpr double level_tolerance = 1e-9;

double uniform_scale_of(const Affine& map) {
  const double xx = dot(map.x, map.x), most = uniform_tolerance * xx;
  const bool alike = std::abs(dot(map.y, map.y) - xx) <= most && std::abs(dot(map.z, map.z) - xx) <= most &&
                     std::abs(dot(map.x, map.y)) <= most && std::abs(dot(map.y, map.z)) <= most &&
                     std::abs(dot(map.z, map.x)) <= most;
  return alike ? std::sqrt(xx) : 0;
}

// How far the shape's linear image reaches along `g`.
double reach(const Shape& shape, const Affine& map, Vec3d g) {
  const Vec3d canonical = apply_transposed(map, g);
  return std::visit([&](const auto& s) { return support(s, canonical); }, shape);
}

double half_extent(const Shape& shape, const Affine& map, Vec3d unit) {
  return (reach(shape, map, unit) + reach(shape, map, -unit)) / 2;
}

// The scale of from_centre.
double unit_of_height(const Shape& shape, const Affine& map) {
  double longest = 0;
  for (const Vec3d axis : {map.x, map.y, map.z})
    longest = std::max(longest, half_extent(shape, map, math::normalize(axis)));
  const double height = half_extent(shape, map, {0, 1, 0});
  return height > level_tolerance * longest ? height : longest;
}

Vec3d object_point(const PlacedShape& placed, Vec3d p) {
  return apply_vector(placed.to_object, p - placed.to_world.origin);  // the difference first: exact far from the origin
}

SurfacePoint to_world(const PlacedShape& placed, const CanonicalPoint& at) {
  const Affine& map = placed.to_world;
  const Vec3d from_origin = apply_vector(map, at.position);
  const bool by_direction = std::visit(
      [](const auto& s) {
        return requires { s.by_direction; };
      },
      placed.shape);
  return {.position = from_origin + map.origin,
          .normal = apply_normal(map, at.normal),
          .tangent_u = math::normalize(apply_vector(map, at.tangent_u)),
          .u = at.u,
          .v = at.v,
          .from_centre = by_direction ? math::normalize(from_origin)
                                      : (from_origin - placed.box_centre) * placed.inverse_half_extent};
}

CanonicalPoint canonical_point(const PlacedShape& placed, Vec3d p) {
  return std::visit([&](const auto& s) { return point_at(s, p); }, placed.shape);
}

double canonical_area(const PlacedShape& placed) {
  return std::visit([](const auto& s) { return area(s); }, placed.shape);
}

double inverse_density_at(const PlacedShape& placed, Vec3d p) {
  return std::visit([&](const auto& s) { return inverse_density(s, p); }, placed.shape);
}

double area_factor(const PlacedShape& placed, Vec3d canonical_normal) {
  return math::length(apply_area_vector(placed.to_world, canonical_normal));
}

// The area, as the mean of the area factor over the canonical shape: along one parameter by `panels` panels of Gauss's
// rule, crowded towards the ends, where long shapes bend most; around the other, which is periodic, by the trapezoid
// rule.
double sampled_area(const PlacedShape& placed, int panels) {
  constexpr double node = 0.77459666924148337704 / 2;  // sqrt(3/5)/2: three points, exact to the fifth degree
  constexpr double pi = std::numbers::pi;
  const int around = 8 * panels;
  double sum = 0;
  for (int i = 0; i < panels; ++i)
    for (const auto& [offset, weight] : {std::pair{-node, 5.0}, std::pair{0.0, 8.0}, std::pair{node, 5.0}}) {
      const double t = (i + 0.5 + offset) / panels, u1 = (1 - std::cos(pi * t)) / 2;
      double row = 0;
      for (int k = 0; k < around; ++k) {
        const double u2 = static_cast<double>(k) / around;
        const Vec3d p = std::visit([&](const auto& s) { return sample(s, u1, u2); }, placed.shape);
        row += area_factor(placed, canonical_point(placed, p).normal) * inverse_density_at(placed, p);
      }
      sum += weight * (pi / 2 * std::sin(pi * t)) * row;
    }
  return sum / (18.0 * panels * around);
}

const SphereCap* round_cap(const PlacedShape& placed) {
  return placed.uniform_scale > 0 ? std::get_if<SphereCap>(&placed.shape) : nullptr;
}

// On a sphere that is one in the world too, by its own equation (23).
std::optional<double> next_crossing(const SphereCap& cap, const PlacedShape& placed, Vec3d origin, Vec3d direction,
                                    bool starts_on_it) {
  const Vec3d center = placed.to_world.origin;
  std::array<double, 2> distances{0, 0};
  if (starts_on_it) {
    distances[1] = chord(origin, direction, center);
  } else {
    const auto roots = sphere_roots(origin, direction, center, placed.uniform_scale);
    if (!(roots.half_chord_squared >= 0)) return {};
    const double half = std::sqrt(roots.half_chord_squared);
    distances = {roots.middle - half, roots.middle + half};
  }
  if (cap.is_whole()) return first_on_cap(cap, distances, 0, 0);
  return first_on_cap(cap, distances, object_point(placed, origin).y, apply_vector(placed.to_object, direction).y);
}

}  // namespace

PlacedShape place(const Shape& shape, const Affine& map) {
  PlacedShape placed;
  placed.shape = shape, placed.to_world = map, placed.to_object = inverse(map);
  placed.uniform_scale = uniform_scale_of(map);
  const Vec3d high{reach(shape, map, {1, 0, 0}), reach(shape, map, {0, 1, 0}), reach(shape, map, {0, 0, 1})};
  const Vec3d low{-reach(shape, map, {-1, 0, 0}), -reach(shape, map, {0, -1, 0}), -reach(shape, map, {0, 0, -1})};
  placed.box = {low + map.origin, high + map.origin};
  placed.box_centre = (low + high) * 0.5;
  placed.inverse_half_extent = 1 / unit_of_height(shape, map);
  return placed;
}

double area(const PlacedShape& placed) {
  if (placed.uniform_scale > 0) return canonical_area(placed) * placed.uniform_scale * placed.uniform_scale;
  const bool flat = std::visit([](const auto& s) { return s.flat; }, placed.shape);
  if (flat) return canonical_area(placed) * area_factor(placed, {0, 0, 1});
  constexpr double enough = 1e-11;
  constexpr int most_panels = 512;
  double area = sampled_area(placed, 1);
  for (int panels = 2; panels <= most_panels; panels *= 2) {
    const double finer = sampled_area(placed, panels);
    const bool settled = std::abs(finer - area) <= enough * finer;
    area = finer;
    if (settled) break;
  }
  return area;
}

std::optional<double> next_crossing(const PlacedShape& placed, Vec3d origin, Vec3d direction, bool starts_on_it) {
  if (const SphereCap* cap = round_cap(placed)) return next_crossing(*cap, placed, origin, direction, starts_on_it);
  const Vec3d o = object_point(placed, origin), d = apply_vector(placed.to_object, direction);
  return std::visit([&](const auto& s) { return next_crossing(s, o, d, starts_on_it); }, placed.shape);
}

SurfacePoint surface_at(const PlacedShape& placed, Vec3d origin, Vec3d direction, double distance) {
  const Vec3d o = object_point(placed, origin), d = apply_vector(placed.to_object, direction);
  return to_world(placed, canonical_point(placed, o + d * distance));
}

SampledPoint sample_area(const PlacedShape& placed, double u1, double u2) {
  const Vec3d p = std::visit([&](const auto& s) { return sample(s, u1, u2); }, placed.shape);
  const CanonicalPoint at = canonical_point(placed, p);
  return {to_world(placed, at), 1 / (inverse_density_at(placed, p) * area_factor(placed, at.normal))};
}

}  // namespace shabon::geometry
