// The list of shapes, and a shape in the world: where rays meet it, what is there, and points of it at random.
#pragma once

#include <optional>
#include <variant>

#include "shabon/geometry/affine.h"
#include "shabon/geometry/shapes/cylinder.h"
#include "shabon/geometry/shapes/disk.h"
#include "shabon/geometry/shapes/lobed_sphere.h"
#include "shabon/geometry/shapes/quad.h"
#include "shabon/geometry/shapes/sphere.h"
#include "shabon/geometry/shapes/torus.h"
#include "shabon/geometry/shapes/triangle.h"

namespace shabon::geometry {

// The list. A new shape is one file in shapes/ with the functions that shapes/canonical.h names.
using Shape = std::variant<SphereCap, Quad, Disk, Cylinder, Triangle, Torus, LobedSphere>;

struct Box {
  math::Vec3d low, high;
};

// Made by place(). All lengths are in the world's units.
struct PlacedShape {
  Shape shape;
  Affine to_world, to_object;
  double uniform_scale = 0;        // where the map turns, mirrors, moves and scales alike in all directions; else 0
  Box box;                         // the tightest one, but for rounding
  math::Vec3d box_centre;          // from to_world.origin
  double inverse_half_extent = 1;  // of the box along the world's y
};

// The map must be invertible: a flat shape too has a scale across its plane, which is of no consequence.
PlacedShape place(const Shape& shape, const Affine& to_world);

inline Box bounds(const PlacedShape& placed) { return placed.box; }

// The inverse of the density of a canonical shape's sample() at a point of it, per area.
template <class AnyShape>
double inverse_density(const AnyShape& shape, [[maybe_unused]] math::Vec3d p) {
  if constexpr (requires { area_per_sample(shape, p); })
    return area_per_sample(shape, p);
  else
    return area(shape);
}

// Exact where the shape is flat or the scale uniform; elsewhere by quadrature, to about ten digits.
double area(const PlacedShape& placed);

struct SurfacePoint {
  math::Vec3d position;
  math::Vec3d normal;     // unit, outward or front as the canonical shape's
  math::Vec3d tangent_u;  // unit, in the direction of rising u
  double u = 0, v = 0;    // 0..1, v from the top
  // From the centre of the box in units of half its extent along the world's y, so that its y runs from -1 to 1 over
  // the shape. Units of a level flat shape are half its extent along its longest axis. On a whole unturned sphere this
  // is the normal. On a shape that goes by direction it is the unit direction from the shape's origin.
  math::Vec3d from_centre;
};

// The least distance > 0 at which a ray meets the shape. `direction` has unit length. Of a ray that starts on the shape
// the other crossing is known without an epsilon; a flat shape has none.
std::optional<double> next_crossing(const PlacedShape& placed, math::Vec3d origin, math::Vec3d direction,
                                    bool starts_on_it);

// What is where next_crossing() found a crossing. The position is on the shape: rounding along the ray is taken out.
SurfacePoint surface_at(const PlacedShape& placed, math::Vec3d origin, math::Vec3d direction, double distance);

struct SampledPoint {
  SurfacePoint at;
  double pdf_area = 0;  // per unit of the world's area
};

// A random point of the shape from two numbers in [0, 1): uniform over the canonical shape, if that says no other. Over
// the placed one it is then uniform where the shape is flat or the scale uniform; pdf_area accounts for the rest.
SampledPoint sample_area(const PlacedShape& placed, double u1, double u2);

struct SampledDirection {
  math::Vec3d direction;  // unit
  double distance = 0;    // to the point that was chosen, which other parts of the shape may hide
  double pdf = 0;         // per steradian
};

// A random direction from a point towards the shape, whichever side it sees. A whole sphere with uniform scale, seen
// from outside: uniform over the cone that it fills, towards its near side. A quad that fills more than 1e-5
// steradians: uniform over what it fills. Else a point by sample_area(). None where the point lies in the plane of a
// flat shape or is the chosen one.
std::optional<SampledDirection> sample_toward(const PlacedShape& placed, math::Vec3d from, double u1, double u2);

// The density, per steradian, with which sample_toward() chooses the crossing at `distance` along `direction`: the
// same bits for what it made. A ray may meet the shape twice; the densities of its crossings then add up to that of the
// direction. A crossing that sample_toward() never chooses has 0.
double pdf_toward(const PlacedShape& placed, math::Vec3d from, math::Vec3d direction, double distance);

}  // namespace shabon::geometry
