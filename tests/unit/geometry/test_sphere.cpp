#include "shabon/geometry/sphere.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_rays.h"
#include "shabon/math/packet.h"

namespace shabon::geometry {
namespace {

using math::Vec3d;
using Exact = math::Vec3<long double>;

Exact exact(Vec3d v) { return {v.x, v.y, v.z}; }

// The roots along the line of this direction, in long double, as distances in units of its length 1.
SphereRoots<long double> exact_roots(Vec3d origin, Vec3d direction, Vec3d center, double radius) {
  const Exact d = math::normalize(exact(direction)), to_center = exact(center) - exact(origin);
  const long double middle = dot(to_center, d);
  const Exact across = to_center - d * middle;
  return {middle, static_cast<long double>(radius) * radius - dot(across, across)};
}

constexpr double eps = 0x1p-53;

// `distance` is how far the origin lies from the centre, in radii: what rounding grows with.
void expect_roots(double distance, std::uint64_t seed) {
  Pcg32 random(seed);
  double worst_middle = 0, worst_chord = 0, worst_place = 0;
  for (int k = 0; k < 20000; ++k) {
    const double radius = std::exp(random.uniform(-5, 5));
    const Vec3d center = random_point(random, 10 * radius);
    const Vec3d origin = center + random_direction(random) * (distance * radius);
    // At a point of the ball around the sphere of 1.2 times its size: some rays miss.
    const Vec3d aim = center + random_direction(random) * (1.2 * radius * std::cbrt(random.uniform()));
    const Vec3d direction = math::normalize(aim - origin);
    const auto roots = sphere_roots(origin, direction, center, radius);
    const auto truth = exact_roots(origin, direction, center, radius);
    const double scale = std::max(1.0, distance) * radius;
    worst_middle = std::max(worst_middle, static_cast<double>(std::abs(roots.middle - truth.middle)) / scale);
    worst_chord =
        std::max(worst_chord,
                 static_cast<double>(std::abs(roots.half_chord_squared - truth.half_chord_squared)) / (scale * radius));
    if (roots.half_chord_squared < 0) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec3d wall = origin + direction * (roots.middle + side * std::sqrt(roots.half_chord_squared));
      worst_place = std::max(worst_place, std::abs(math::length(wall - center) - radius) / scale);
    }
  }
  EXPECT_LT(worst_middle, 8 * eps) << distance;
  EXPECT_LT(worst_chord, 24 * eps) << distance;
  EXPECT_LT(worst_place, 24 * eps) << distance;
}

TEST(SphereRoots, InsideAndNear) {
  expect_roots(0.5, 1);
  expect_roots(1, 2);
  expect_roots(5, 3);
}

// From a million radii away the wall is placed to 1e-9 of the radius; b^2 - 4ac would lose it by 1e-4.
TEST(SphereRoots, FromFarAway) {
  expect_roots(1e3, 4);
  expect_roots(1e6, 5);
}

TEST(SphereRoots, SpheresFarFromTheOriginOfTheScene) {
  Pcg32 random(6);
  const Vec3d center{1e6, -1e6, 1e6};
  for (int k = 0; k < 1000; ++k) {
    const Vec3d origin = center + random_direction(random) * 3.0;
    const Vec3d direction = math::normalize(center + random_point(random, 0.5) - origin);
    const auto roots = sphere_roots(origin, direction, center, 1.0);
    const auto truth = exact_roots(origin, direction, center, 1.0);
    EXPECT_NEAR(roots.middle, static_cast<double>(truth.middle), 1e-14);
    EXPECT_NEAR(roots.half_chord_squared, static_cast<double>(truth.half_chord_squared), 1e-14);
  }
}

TEST(SphereRoots, KnownRays) {
  const auto through = sphere_roots(Vec3d{0, 0, 4}, Vec3d{0, 0, -1}, Vec3d{0, 0, 0}, 1.0);
  EXPECT_EQ(through.middle, 4);
  EXPECT_EQ(through.half_chord_squared, 1);
  const auto tangent = sphere_roots(Vec3d{1, 0, 4}, Vec3d{0, 0, -1}, Vec3d{0, 0, 0}, 1.0);
  EXPECT_EQ(tangent.half_chord_squared, 0);
  const auto past = sphere_roots(Vec3d{2, 0, 4}, Vec3d{0, 0, -1}, Vec3d{0, 0, 0}, 1.0);
  EXPECT_EQ(past.half_chord_squared, -3);
  const auto behind = sphere_roots(Vec3d{0, 0, 4}, Vec3d{0, 0, 1}, Vec3d{0, 0, 0}, 1.0);
  EXPECT_EQ(behind.middle, -4);
}

TEST(SphereRoots, PacketsGiveTheSameBits) {
  using Rays = math::packet<double, 8>;
  Pcg32 random(7);
  for (int k = 0; k < 1000; ++k) {
    const Vec3d origin = random_point(random, 5), direction = random_direction(random),
                center = random_point(random, 2);
    const auto one = sphere_roots(origin, direction, center, 1.5);
    const auto all = sphere_roots<Rays>({Rays(origin.x), Rays(origin.y), Rays(origin.z)},
                                        {Rays(direction.x), Rays(direction.y), Rays(direction.z)},
                                        {Rays(center.x), Rays(center.y), Rays(center.z)}, Rays(1.5));
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(all.middle[i], one.middle);
      EXPECT_EQ(all.half_chord_squared[i], one.half_chord_squared);
    }
  }
}

TEST(Chord, ReachesTheOtherWall) {
  Pcg32 random(8);
  for (int k = 0; k < 10000; ++k) {
    const Vec3d center = random_point(random, 3);
    const double radius = random.uniform(0.1, 3);
    const Vec3d wall = center + random_direction(random) * radius, direction = random_direction(random);
    const double t = chord(wall, direction, center);
    EXPECT_EQ(t > 0, dot(direction, center - wall) > 0);
    EXPECT_NEAR(math::length(wall + direction * t - center), radius, 5e-15);
  }
}

}  // namespace
}  // namespace shabon::geometry
