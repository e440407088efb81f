// What the tests of shapes know about each of the list on their own: its equation, its edge, a parametrisation. A shape
// that is on the list and not here does not compile.
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "random_rays.h"
#include "shabon/geometry/shape.h"

namespace shabon::geometry {

using math::Vec3d;
using Real = long double;
using Vec3r = math::Vec3<Real>;

inline Vec3r real(Vec3d v) { return {v.x, v.y, v.z}; }

// examples(): one of each kind. carrier(): zero on the endless surface, rising along the normal; of the second degree
// except where `any_degree` stands.
// edge(): not negative where the shape exists. parametrized(): the shape, from the unit square. uv(): of a point of it.
template <class T>
struct Known;

template <>
struct Known<SphereCap> {
  static std::vector<SphereCap> examples() { return {{-1}, {-0.6}, {0}, {0.9}}; }
  static Real carrier(const SphereCap&, Vec3r p) { return dot(p, p) - 1; }
  static Real edge(const SphereCap& s, Vec3r p) { return s.cos_cap == -1 ? 1 : p.y - s.cos_cap; }
  static Vec3d parametrized(const SphereCap& s, double a, double b) {
    const double theta = a * std::acos(s.cos_cap), phi = 2 * std::numbers::pi * b;
    return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
  }
  static Vec3d uv(Vec3d p) {
    return {0.5 + std::atan2(p.x, -p.z) / (2 * std::numbers::pi), std::acos(p.y) / std::numbers::pi, 0};
  }
};

template <>
struct Known<Quad> {
  static std::vector<Quad> examples() { return {{}}; }
  static Real carrier(const Quad&, Vec3r p) { return p.z; }
  static Real edge(const Quad&, Vec3r p) { return std::min(1 - std::abs(p.x), 1 - std::abs(p.y)); }
  static Vec3d parametrized(const Quad&, double a, double b) { return {2 * a - 1, 2 * b - 1, 0}; }
  static Vec3d uv(Vec3d p) { return {(p.x + 1) / 2, (1 - p.y) / 2, 0}; }
};

template <>
struct Known<Disk> {
  static std::vector<Disk> examples() { return {{0}, {0.4}, {0.95}}; }
  static Real carrier(const Disk&, Vec3r p) { return p.z; }
  static Real edge(const Disk& s, Vec3r p) {
    const Real r = std::sqrt(p.x * p.x + p.y * p.y);
    return std::min(1 - r, s.hole == 0 ? 1 : r - s.hole);
  }
  static Vec3d parametrized(const Disk& s, double a, double b) {
    const double r = s.hole + a * (1 - s.hole), phi = 2 * std::numbers::pi * b;
    return {r * std::sin(phi), r * std::cos(phi), 0};
  }
  static Vec3d uv(Vec3d p) { return Known<Quad>::uv(p); }
};

template <>
struct Known<Cylinder> {
  static std::vector<Cylinder> examples() { return {{}}; }
  static Real carrier(const Cylinder&, Vec3r p) { return p.x * p.x + p.z * p.z - 1; }
  static Real edge(const Cylinder&, Vec3r p) { return 1 - std::abs(p.y); }
  static Vec3d parametrized(const Cylinder&, double a, double b) {
    const double phi = 2 * std::numbers::pi * b;
    return {std::cos(phi), 2 * a - 1, std::sin(phi)};
  }
  static Vec3d uv(Vec3d p) { return {0.5 + std::atan2(p.x, -p.z) / (2 * std::numbers::pi), (1 - p.y) / 2, 0}; }
};

template <>
struct Known<Triangle> {
  static std::vector<Triangle> examples() { return {{}}; }
  static Real carrier(const Triangle&, Vec3r p) { return p.z; }
  static Real edge(const Triangle&, Vec3r p) { return std::min({p.x, p.y, 1 - p.x - p.y}); }
  static Vec3d parametrized(const Triangle&, double a, double b) { return {a, b * (1 - a), 0}; }
  static Vec3d uv(Vec3d p) { return {p.x, 1 - p.y, 0}; }
};

template <>
struct Known<Torus> {
  static constexpr bool any_degree = true;
  static std::vector<Torus> examples() { return {{0.5}, {0.1}, {0.9}}; }
  static Real carrier(const Torus& s, Vec3r p) {
    const Real r = std::sqrt(p.x * p.x + p.z * p.z) - 1;
    return std::sqrt(r * r + p.y * p.y) - s.tube;
  }
  static Real edge(const Torus&, Vec3r) { return 1; }
  static Vec3d parametrized(const Torus& s, double a, double b) {
    const double around = 2 * std::numbers::pi * a, azimuth = 2 * std::numbers::pi * b;
    const double r = 1 + s.tube * std::cos(around);
    return {r * std::cos(azimuth), s.tube * std::sin(around), r * std::sin(azimuth)};
  }
  static Vec3d uv(Vec3d p) {
    const double turn = std::atan2(std::hypot(p.x, p.z) - 1, p.y) / (2 * std::numbers::pi);
    return {0.5 + std::atan2(p.x, -p.z) / (2 * std::numbers::pi), turn < 0 ? turn + 1 : turn, 0};
  }
};

template <>
struct Known<LobedSphere> {
  static constexpr bool any_degree = true;
  static std::vector<LobedSphere> examples() {
    const Vec3d slant = math::normalize(Vec3d{1, 2, -3}), other = math::normalize(Vec3d{-2, 0.3, 1});
    return {{0.98, {{2, 0.25, {0, 1, 0}}}},                                     // a gherkin
            {1.01, {{2, -0.35, slant}, {3, 0.1, other}}},                       // with a waist
            {1, {{5, 0.15, slant}, {4, -0.1, {1, 0, 0}}, {12, 0.02, other}}}};  // knobbly
  }
  static Real legendre(int degree, Real x) {
    Real before = 1, now = x;
    for (int n = 1; n < degree; ++n) before = std::exchange(now, ((2 * n + 1) * x * now - n * before) / (n + 1));
    return now;
  }
  static Real carrier(const LobedSphere& s, Vec3r p) {
    const Real q = std::sqrt(dot(p, p));
    Real height = q - s.mean;
    for (const Lobe& lobe : s.lobes) height -= lobe.amplitude * legendre(lobe.degree, dot(p, real(lobe.axis)) / q);
    return height;
  }
  static Real edge(const LobedSphere&, Vec3r) { return 1; }
  static Vec3d parametrized(const LobedSphere& s, double a, double b) {
    const Vec3d n = Known<SphereCap>::parametrized({}, a, b);
    return n * static_cast<double>(-carrier(s, real(n)) + 1);
  }
  static Vec3d uv(Vec3d p) { return Known<SphereCap>::uv(math::normalize(p)); }
};

template <class List>
struct AsTypes;
template <class... T>
struct AsTypes<std::variant<T...>> {
  using Types = testing::Types<T...>;
};
using EveryShape = AsTypes<Shape>::Types;

enum class MapKind { uniform, stretched, sheared, mirrored };
inline constexpr MapKind map_kinds[] = {MapKind::uniform, MapKind::stretched, MapKind::sheared, MapKind::mirrored};

inline Affine random_map(Pcg32& random, MapKind kind, double reach = 3) {
  const auto factor = [&] { return std::exp(random.uniform(-1.2, 1.2)); };
  const double size = factor();
  Vec3d scale{size, size, size};
  if (kind != MapKind::uniform) scale = {size * factor(), size * factor(), size * factor()};
  if (kind == MapKind::mirrored) scale.y = -scale.y;
  const Vec3d turn_deg = random_point(random, 180);
  Affine map = placement(random_point(random, reach), turn_deg, scale);
  if (kind == MapKind::sheared) map.x = map.x + map.y * random.uniform(-1, 1), map.z = map.z + map.x * 0.5;
  return map;
}

// A point in the shape's own coordinates: Cramer's rule in extended precision.
inline Vec3r solve(const Affine& map, Vec3r p) {
  const Vec3r x = real(map.x), y = real(map.y), z = real(map.z), at = p - real(map.origin);
  const Real d = dot(x, cross(y, z));
  return {dot(at, cross(y, z)) / d, dot(x, cross(at, z)) / d, dot(x, cross(y, at)) / d};
}

inline double size_of(const PlacedShape& placed) { return math::length(placed.box.high - placed.box.low); }

// The surface as a fine net of triangles, for sums that know nothing of how points are sampled.
template <class T, class Visit>
void for_each_facet(const T& shape, const Affine& map, int n, const Visit& visit) {
  const auto at = [&](int i, int k) {
    return apply_point(map, Known<T>::parametrized(shape, static_cast<double>(i) / n, static_cast<double>(k) / n));
  };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const Vec3d a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1), d = at(i, k + 1);
      visit((a + b + c) * (1 / 3.0), math::length(cross(b - a, c - a)) / 2);
      visit((a + c + d) * (1 / 3.0), math::length(cross(c - a, d - a)) / 2);
    }
}

// A test body for every example of the type and every kind of map.
template <class T, class Body>
void for_each_placed(std::uint64_t seed, int maps_each, const Body& body) {
  Pcg32 random(seed);
  for (const T& shape : Known<T>::examples())
    for (const MapKind kind : map_kinds)
      for (int k = 0; k < maps_each; ++k) {
        const PlacedShape placed = place(shape, random_map(random, kind));
        SCOPED_TRACE(std::string(T::name) + ", map " + std::to_string(static_cast<int>(kind)));
        body(shape, placed, random);
        if (testing::Test::HasFatalFailure()) return;
      }
}

}  // namespace shabon::geometry
