#include "shabon/geometry/shape.h"
#include "shabon/geometry/sphere.h"
#include "shabon/geometry/spherical_rectangle.h"

namespace shabon::geometry {

namespace {

using math::Vec3d;

// The cone that a whole sphere fills, seen from a point outside.
struct Cone {
  Vec3d axis;                // unit, towards the centre
  double one_minus_cos = 0;  // of half its opening; exact also where the sphere is tiny or far
};

std::optional<Cone> cone_of(const PlacedShape& placed, Vec3d from) {
  const auto* sphere = std::get_if<SphereCap>(&placed.shape);
  if (!sphere || !sphere->is_whole() || !(placed.uniform_scale > 0)) return {};
  const Vec3d to_center = placed.to_world.origin - from;
  const double distance = math::length(to_center), radius = placed.uniform_scale;
  if (!(distance > radius)) return {};
  const double sine = radius / distance;
  const double cosine = std::sqrt((distance - radius) * (distance + radius)) / distance;
  return Cone{to_center * (1 / distance), sine * sine / (1 + cosine)};
}

double pdf_in(const Cone& cone) { return 1 / (2 * std::numbers::pi * cone.one_minus_cos); }

// The near crossing of a line that is known to meet the sphere: one past the rim by rounding touches it.
struct NearSide {
  double middle, distance;
};

NearSide near_side(const PlacedShape& placed, Vec3d from, Vec3d direction) {
  const auto roots = sphere_roots(from, direction, placed.to_world.origin, placed.uniform_scale);
  return {roots.middle, std::max(0.0, roots.middle - std::sqrt(std::max(0.0, roots.half_chord_squared)))};
}

// Two unit vectors at right angles to a unit vector and to each other (Duff and others, "Building an orthonormal basis,
// revisited", J. Computer Graphics Techniques 6 (2017) 1).
std::array<Vec3d, 2> across(Vec3d n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {Vec3d{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, Vec3d{b, sign + n.y * n.y * a, -n.y}};
}

Vec3d direction_in(const Cone& cone, double u1, double u2) {
  const double one_minus_cos = u1 * cone.one_minus_cos;
  const double sine = std::sqrt(one_minus_cos * (2 - one_minus_cos)), phi = 2 * std::numbers::pi * u2;
  const auto [s, t] = across(cone.axis);
  return math::normalize(cone.axis * (1 - one_minus_cos) + s * (sine * std::cos(phi)) + t * (sine * std::sin(phi)));
}

// A rectangle that is seen under more than this: below, its points by area are as even, and more exact.
constexpr double least_steradians = 1e-5;

std::optional<SphericalRectangle> rectangle_of(const PlacedShape& placed, Vec3d from) {
  constexpr double rounding = 1e-12;
  if (!std::holds_alternative<Quad>(placed.shape)) return {};
  const Affine& to = placed.to_world;
  if (!(std::abs(dot(to.x, to.y)) <= rounding * math::length(to.x) * math::length(to.y))) return {};  // sheared
  const SphericalRectangle seen(to.origin - from, to.x, to.y);
  const bool aside = seen.above() > rounding * (math::length(to.x) + math::length(to.y));
  if (!aside || !(seen.solid_angle() >= least_steradians)) return {};
  return seen;
}

double pdf_by_area(const PlacedShape& placed, Vec3d from, Vec3d direction, double distance) {
  const Vec3d d = apply_vector(placed.to_object, direction);
  const Vec3d p = apply_vector(placed.to_object, from - placed.to_world.origin) + d * distance;
  return std::visit(
      [&](const auto& s) {
        // The area that a steradian covers: distance^2 / cos, where the length of the area vector holds the area
        // factor.
        const Vec3d across_it = apply_area_vector(placed.to_world, point_at(s, p).normal);
        const double projected = inverse_density(s, p) * std::abs(dot(across_it, direction));
        const double pdf = distance * distance / projected;
        return std::isfinite(pdf) ? pdf : 0;
      },
      placed.shape);
}

}  // namespace

double pdf_toward(const PlacedShape& placed, Vec3d from, Vec3d direction, double distance) {
  if (const auto rectangle = rectangle_of(placed, from)) return 1 / rectangle->solid_angle();
  const auto cone = cone_of(placed, from);
  if (!cone) return pdf_by_area(placed, from, direction, distance);
  return distance <= near_side(placed, from, direction).middle ? pdf_in(*cone) : 0;
}

std::optional<SampledDirection> sample_toward(const PlacedShape& placed, Vec3d from, double u1, double u2) {
  if (const auto cone = cone_of(placed, from)) {
    const Vec3d direction = direction_in(*cone, u1, u2);
    return SampledDirection{direction, near_side(placed, from, direction).distance, pdf_in(*cone)};
  }
  if (const auto rectangle = rectangle_of(placed, from)) {
    const Vec3d to_point = rectangle->sample(u1, u2);
    const double distance = math::length(to_point);
    return SampledDirection{to_point * (1 / distance), distance, 1 / rectangle->solid_angle()};
  }
  const Vec3d to_point = sample_area(placed, u1, u2).at.position - from;
  const double distance = math::length(to_point);
  if (!(distance > 0)) return {};
  const Vec3d direction = to_point * (1 / distance);
  const double pdf = pdf_toward(placed, from, direction, distance);
  if (!(pdf > 0)) return {};
  return SampledDirection{direction, distance, pdf};
}

}  // namespace shabon::geometry
