// The objects other than bubbles, as a scene file states them: a shape, where it stands, and what it is made of.
#pragma once

#include <tuple>
#include <vector>

#include "shabon/base/field.h"
#include "shabon/math/vec.h"
#include "shabon/scene/ranges.h"
#include "shabon/scene/surface.h"

namespace shabon::scene {

// First scaled along the shape's own axes, then turned about the world's x, y and z axis in this order, then moved.
struct PlacementDesc {
  math::Vec3d position{0, 0, 0}, rotation_deg{0, 0, 0}, scale{1, 1, 1};
};

struct SphereDesc : PlacementDesc {
  double radius = 1;
  double cap_deg = 180;  // from the pole +y to the rim
  SurfaceDesc surface = {};
};

struct QuadDesc : PlacementDesc {
  double width = 2, height = 2;
  SurfaceDesc surface = {};
};

struct DiskDesc : PlacementDesc {
  double radius = 1, hole_radius = 0;
  SurfaceDesc surface = {};
};

struct CylinderDesc : PlacementDesc {
  double radius = 1, height = 2;
  SurfaceDesc surface = {};
};

struct TorusDesc : PlacementDesc {
  double radius = 1, tube_radius = 0.05;
  SurfaceDesc surface = {};
};

struct TriangleDesc {
  std::vector<math::Vec3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // anticlockwise as seen from the front
  SurfaceDesc surface = {};
};

constexpr auto fields(Of<PlacementDesc>) {
  constexpr FieldInfo turn{
      .unit = "degrees", .range = angle_range_deg, .doc = "turned about the x, then the y, then the z axis"};
  return std::tuple{
      Field{"position", &PlacementDesc::position, {.range = coordinate_range, .doc = "where its middle stands"}},
      Field{"rotation_deg", &PlacementDesc::rotation_deg, turn},
      Field{"scale",
            &PlacementDesc::scale,
            {.range = stretch_range, .doc = "stretched along its own axes, before all else"}}};
}

template <class Shape>
constexpr auto surface_field() {
  return std::tuple{Field{"surface", &Shape::surface, {.required = true, .doc = "what it is made of"}}};
}

constexpr About about(Of<SphereDesc>) { return {.name = "sphere", .doc = "a sphere, or a cap of one"}; }
constexpr auto fields(Of<SphereDesc>) {
  return std::tuple_cat(
      fields(Of<PlacementDesc>{}),
      std::tuple{Field{"radius", &SphereDesc::radius, {.range = radius_range, .doc = "its radius"}},
                 Field{"cap_deg",
                       &SphereDesc::cap_deg,
                       {.unit = "degrees",
                        .range = up_to_half_turn_deg,
                        .doc = "what is there of it: from its own +y axis to the rim; 180 is the whole sphere"}}},
      surface_field<SphereDesc>());
}

constexpr About about(Of<QuadDesc>) { return {.name = "quad", .doc = "a rectangle; its front is its own +z"}; }
constexpr auto fields(Of<QuadDesc>) {
  return std::tuple_cat(
      fields(Of<PlacementDesc>{}),
      std::tuple{Field{"width", &QuadDesc::width, {.range = radius_range, .doc = "along its own x axis"}},
                 Field{"height", &QuadDesc::height, {.range = radius_range, .doc = "along its own y axis"}}},
      surface_field<QuadDesc>());
}

constexpr About about(Of<DiskDesc>) { return {.name = "disk", .doc = "a disk or a ring; its front is its own +z"}; }
constexpr auto fields(Of<DiskDesc>) {
  return std::tuple_cat(
      fields(Of<PlacementDesc>{}),
      std::tuple{Field{"radius", &DiskDesc::radius, {.range = radius_range, .doc = "its radius"}},
                 Field{"hole_radius",
                       &DiskDesc::hole_radius,
                       {.range = hole_range, .doc = "radius of the hole; less than that of the disk"}}},
      surface_field<DiskDesc>());
}

constexpr About about(Of<CylinderDesc>) {
  return {.name = "cylinder", .doc = "an open tube about its own y axis; its front is the outside"};
}
constexpr auto fields(Of<CylinderDesc>) {
  return std::tuple_cat(
      fields(Of<PlacementDesc>{}),
      std::tuple{Field{"radius", &CylinderDesc::radius, {.range = radius_range, .doc = "its radius"}},
                 Field{"height", &CylinderDesc::height, {.range = radius_range, .doc = "along its own y axis"}}},
      surface_field<CylinderDesc>());
}

constexpr About about(Of<TorusDesc>) {
  return {.name = "torus", .doc = "a closed ring of round wire about its own y axis"};
}
constexpr auto fields(Of<TorusDesc>) {
  return std::tuple_cat(
      fields(Of<PlacementDesc>{}),
      std::tuple{
          Field{"radius", &TorusDesc::radius, {.range = radius_range, .doc = "from its axis to the wire's middle"}},
          Field{"tube_radius",
                &TorusDesc::tube_radius,
                {.range = tube_range, .doc = "of the wire; less than that of the ring"}}},
      surface_field<TorusDesc>());
}

constexpr About about(Of<TriangleDesc>) { return {.name = "triangle", .doc = "a triangle"}; }
constexpr auto fields(Of<TriangleDesc>) {
  return std::tuple_cat(std::tuple{Field{"corners",
                                         &TriangleDesc::corners,
                                         {.range = coordinate_range,
                                          .required = true,
                                          .items = 3,
                                          .doc = "three points [x, y, z], anticlockwise as seen from its front"}}},
                        surface_field<TriangleDesc>());
}

void check(const DiskDesc& disk, const Path& path, Problems& problems);
void check(const TorusDesc& torus, const Path& path, Problems& problems);
void check(const TriangleDesc& triangle, const Path& path, Problems& problems);

}  // namespace shabon::scene
