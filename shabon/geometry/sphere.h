// Where a straight ray crosses a sphere, in double precision; equation (23).
#pragma once

#include <cmath>

#include "shabon/math/vec.h"

namespace shabon::geometry {

struct SphereShape {
  math::Vec3d center;
  double radius = 1;
};

// T is double or a packet of doubles. `half_chord_squared` is negative where the ray's line misses the sphere.
template <class T>
struct SphereRoots {
  T middle;              // distance to the point of the line nearest to the centre
  T half_chord_squared;  // the roots are middle -+ sqrt(half_chord_squared)
};

// `direction` has unit length. The distance from the centre to the line is taken as a vector: no difference of two
// squares of the distance to the origin, which loses all digits for far spheres.
template <class T>
SphereRoots<T> sphere_roots(math::Vec3<T> origin, math::Vec3<T> direction, math::Vec3<T> center, T radius) {
  const math::Vec3<T> to_center = center - origin;
  const T middle = dot(to_center, direction);
  const math::Vec3<T> across = to_center - direction * middle;
  return {middle, radius * radius - dot(across, across)};
}

// The other root for a ray that starts on the sphere: exact without an epsilon. Not positive: the ray leaves the
// sphere.
template <class T>
T chord(math::Vec3<T> point_on_sphere, math::Vec3<T> direction, math::Vec3<T> center) {
  return T(2.0) * dot(center - point_on_sphere, direction);
}

}  // namespace shabon::geometry
