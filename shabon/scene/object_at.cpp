#include "shabon/scene/object_at.h"

#include <algorithm>
#include <cmath>

namespace shabon::scene {

namespace {

// In units of the object's size.
constexpr double on_surface_tolerance = 1e-9;

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
bool is_on(const geometry::Torus& torus, const math::Vec3d& p, double tolerance) {
  return std::abs(std::hypot(std::hypot(p.x, p.z) - 1, p.y) - torus.tube) <= tolerance;
}
bool is_on(const geometry::LobedSphere& lobed, const math::Vec3d& p, double tolerance) {
  const double distance = math::length(p);
  return distance > 0 && std::abs(distance - geometry::radius_at(lobed, p * (1 / distance))) <= tolerance;
}

bool stands_on(const geometry::PlacedShape& placed, const math::Vec3d& point) {
  const math::Vec3d p = geometry::apply_point(placed.to_object, point);
  return std::visit([&](const auto& shape) { return is_on(shape, p, on_surface_tolerance); }, placed.shape);
}

}  // namespace

std::optional<int> object_at(const Scene& scene, const math::Vec3d& point) {
  for (const Object& object : scene.objects)
    if (stands_on(object.shape, point)) return object.place_in_file;
  return {};
}

}  // namespace shabon::scene
