// A closed surface around the origin whose distance from it differs from direction to direction: a sphere with lobes.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "shabon/geometry/shapes/canonical.h"

namespace shabon::geometry {

// Adds amplitude P(n . axis) to the radius, with the Legendre polynomial P of this degree.
struct Lobe {
  int degree = 2;
  double amplitude = 0;
  math::Vec3d axis{0, 1, 0};  // unit
  friend bool operator==(const Lobe&, const Lobe&) = default;
};

// The radius in the direction n is mean + sum of the lobes. The amplitudes must add up to less than the mean, so that
// the radius is above 0. Normal outward; u and v by direction as on the sphere. from_centre is the direction.
struct LobedSphere {
  static constexpr std::string_view name = "lobed sphere";
  static constexpr bool flat = false;
  static constexpr bool by_direction = true;
  double mean = 1;
  std::vector<Lobe> lobes;
};

// In the unit direction n.
double radius_at(const LobedSphere& lobed, math::Vec3d n);

double area(const LobedSphere& lobed);
double support(const LobedSphere& lobed, math::Vec3d g);
// Crossings are found from outside of what they may be by steps that are too short to miss one: a bound on the second
// derivative of |p| - radius along the ray limits how soon it can be 0, which is Newton's method from one side.
std::optional<double> next_crossing(const LobedSphere& lobed, math::Vec3d origin, math::Vec3d direction,
                                    bool starts_on_it);
CanonicalPoint point_at(const LobedSphere& lobed, math::Vec3d p);
// Uniform over the directions, not over the area.
math::Vec3d sample(const LobedSphere& lobed, double u1, double u2);
double area_per_sample(const LobedSphere& lobed, math::Vec3d p);

}  // namespace shabon::geometry
