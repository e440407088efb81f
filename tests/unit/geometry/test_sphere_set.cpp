// The next wall by Embree against looking at every sphere: the same answer to the last bit.
#include "shabon/geometry/sphere_set.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "random_rays.h"

namespace shabon::geometry {
namespace {

using math::Vec3d;
using Spheres = std::vector<SphereShape>;

// The rule of sphere_set.h, written down once more.
std::optional<WallHit> next_wall_of_all(const Spheres& spheres, Vec3d origin, Vec3d direction, int from) {
  WallHit nearest{std::numeric_limits<double>::infinity(), no_sphere};
  for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
    const SphereShape& sphere = spheres[static_cast<std::size_t>(i)];
    double distance = chord(origin, direction, sphere.center);
    if (i != from) {
      const auto roots = sphere_roots(origin, direction, sphere.center, sphere.radius);
      if (!(roots.half_chord_squared >= 0)) continue;
      const double half = std::sqrt(roots.half_chord_squared);
      distance = roots.middle - half > 0 ? roots.middle - half : roots.middle + half;
    }
    if (distance > 0 && distance < nearest.distance) nearest = {distance, i};
  }
  if (nearest.sphere == no_sphere) return {};
  return nearest;
}

struct Tally {
  int rays = 0, hits = 0, wrong = 0;
};

void compare(const SphereSet& set, const Spheres& spheres, Vec3d origin, Vec3d direction, int from, Tally& tally) {
  const auto expected = next_wall_of_all(spheres, origin, direction, from);
  const auto found = set.next_wall(origin, direction, from);
  ++tally.rays;
  if (expected) ++tally.hits;
  const bool same = expected.has_value() == found.has_value() &&
                    (!found || (found->distance == expected->distance && found->sphere == expected->sphere));
  if (same) return;
  if (++tally.wrong <= 3)
    ADD_FAILURE() << "from (" << origin.x << ", " << origin.y << ", " << origin.z << ") along (" << direction.x << ", "
                  << direction.y << ", " << direction.z << ") expected sphere "
                  << (expected ? expected->sphere : no_sphere) << " at " << (expected ? expected->distance : 0)
                  << ", got " << (found ? found->sphere : no_sphere) << " at " << (found ? found->distance : 0);
}

// Follows a ray from wall to wall, through it or off into any direction.
void follow(const SphereSet& set, const Spheres& spheres, Vec3d origin, Vec3d direction, Pcg32& random, Tally& tally) {
  int from = no_sphere;
  for (int event = 0; event < 12; ++event) {
    compare(set, spheres, origin, direction, from, tally);
    const auto hit = next_wall_of_all(spheres, origin, direction, from);
    if (!hit) return;
    origin = origin + direction * hit->distance;
    from = hit->sphere;
    if (random() & 1) direction = random_direction(random);
  }
}

// Rays of all kinds around `middle`: from inside and outside, along walls, from one sphere to the next.
void expect_same_walls(const Spheres& spheres, Vec3d middle, double reach, int paths, std::uint64_t seed) {
  const SphereSet set{Spheres(spheres), WallSearch::tree};
  ASSERT_FALSE(set.has_few());
  Pcg32 random(seed);
  Tally tally;
  const auto any = [&] { return spheres[random() % spheres.size()]; };
  for (int k = 0; k < paths; ++k) {
    const Vec3d start = middle + random_point(random, reach);
    follow(set, spheres, start, random_direction(random), random, tally);
    const SphereShape target = any(), other = any();
    const Vec3d from_wall = other.center + random_direction(random) * other.radius;
    const Vec3d to_wall = target.center + random_direction(random) * target.radius;
    if (from_wall == to_wall) continue;
    follow(set, spheres, from_wall, math::normalize(to_wall - from_wall), random, tally);
    // A line that touches the target, from afar.
    const Vec3d normal = random_direction(random), aside = math::cross(normal, random_direction(random));
    if (math::length(aside) < 1e-3) continue;
    const Vec3d along = math::normalize(aside);
    const double nearly = 1 + (random() % 3 - 1.0) * random.uniform(0, 1e-6);
    compare(set, spheres, target.center + normal * (target.radius * nearly) - along * (2 * reach), along, no_sphere,
            tally);
  }
  EXPECT_EQ(tally.wrong, 0) << "of " << tally.rays;
  EXPECT_GT(tally.hits, tally.rays / 10) << "of " << tally.rays;
  std::printf("[ measured ] %d rays, %d hits, %d wrong\n", tally.rays, tally.hits, tally.wrong);
}

Spheres scattered(int count, double reach, double least_radius, double largest_radius, std::uint64_t seed) {
  Pcg32 random(seed);
  Spheres spheres;
  for (int i = 0; i < count; ++i)
    spheres.push_back(
        {random_point(random, reach), least_radius * std::pow(largest_radius / least_radius, random.uniform())});
  return spheres;
}

Spheres moved(Spheres spheres, Vec3d by, double scale = 1) {
  for (SphereShape& s : spheres) s = {s.center * scale + by, s.radius * scale};
  return spheres;
}

TEST(SphereSet, OverlappingSpheres) { expect_same_walls(scattered(40, 3, 0.3, 1.5, 1), {}, 5, 6000, 1); }

TEST(SphereSet, ManySmallSpheres) { expect_same_walls(scattered(300, 5, 0.2, 0.5, 2), {}, 6, 1500, 2); }

TEST(SphereSet, RadiiFromTinyToHuge) { expect_same_walls(scattered(60, 3, 1e-7, 1e4, 3), {}, 5, 4000, 3); }

TEST(SphereSet, Nested) {
  Spheres spheres;
  for (int i = 0; i < 20; ++i) spheres.push_back({{0.01 * i, 0, 0}, 1 + 0.05 * i});
  for (int i = 0; i < 10; ++i) spheres.push_back({{}, 3 - 1e-9 * i});  // walls closer than float can tell
  expect_same_walls(spheres, {}, 4, 3000, 4);
}

TEST(SphereSet, TouchingSpheres) {
  Spheres spheres;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) spheres.push_back({{2.0 * x, 2.0 * y, 2.0 * z}, 1});
  expect_same_walls(spheres, {3, 3, 3}, 6, 3000, 5);
  // Along the line through the points where they touch: every distance is exact.
  const SphereSet set{Spheres(spheres)};
  Tally tally;
  for (const double start : {-5.0, -1.0, 1.0, 0.0}) compare(set, spheres, {start, 0, 0}, {1, 0, 0}, no_sphere, tally);
}

TEST(SphereSet, FarFromTheOrigin) {
  const Vec3d far{1e6, -2e6, 3e6};
  expect_same_walls(moved(scattered(40, 3, 0.1, 1, 6), far), far, 5, 3000, 6);
}

TEST(SphereSet, SeenFromFarAway) {
  const Spheres spheres = scattered(40, 3, 0.1, 1, 7);
  const SphereSet set{Spheres(spheres)};
  Pcg32 random(7);
  Tally tally;
  for (const double distance : {1e2, 1e4, 1e6, 1e8})
    for (int k = 0; k < 5000; ++k) {
      const Vec3d origin = random_direction(random) * distance;
      compare(set, spheres, origin, math::normalize(random_point(random, 3) - origin), no_sphere, tally);
    }
  EXPECT_GT(tally.hits, tally.rays / 4);
}

TEST(SphereSet, OfAnySize) {
  for (const double scale : {1e-30, 1e-9, 1e9, 1e30})
    expect_same_walls(moved(scattered(30, 3, 0.1, 1, 8), {}, scale), {}, 5 * scale, 1000, 8);
}

TEST(SphereSet, SmallSpheresBesideAWorld) {
  Spheres spheres = scattered(30, 3, 0.1, 1, 9);
  spheres.push_back({{0, -1e9, 0}, 1e9 - 1});
  expect_same_walls(spheres, {}, 5, 2000, 9);
}

// Coincident walls are met in the order of the list, from outside and from inside.
TEST(SphereSet, EqualDistancesGoByTheList) {
  for (const WallSearch search : {WallSearch::one_by_one, WallSearch::tree}) {
    const SphereSet set(Spheres(12, SphereShape{{1, 2, 3}, 2}), search);
    EXPECT_EQ(set.has_few(), search == WallSearch::one_by_one);
    Pcg32 random(10);
    for (int k = 0; k < 1000; ++k) {
      const Vec3d outside = Vec3d{1, 2, 3} + random_direction(random) * 5.0;
      const Vec3d inwards = math::normalize(Vec3d{1, 2, 3} + random_point(random, 0.5) - outside);
      EXPECT_EQ(set.next_wall(outside, inwards)->sphere, 0);
      EXPECT_EQ(set.next_wall({1, 2.5, 3}, random_direction(random))->sphere, 0);
    }
  }
}

TEST(SphereSet, TheNumberDecidesHowWallsAreFound) {
  for (const int count : {SphereSet::few, SphereSet::few + 1}) {
    const SphereSet set(Spheres(static_cast<std::size_t>(count), SphereShape{}));
    EXPECT_EQ(set.has_few(), count <= SphereSet::few);
  }
}

TEST(SphereSet, AWallIsNotMetAgainWhereItIsLeft) {
  for (const WallSearch search : {WallSearch::one_by_one, WallSearch::tree}) {
    Spheres spheres{{{0, 0, 0}, 1}};
    for (int i = 0; i < 20; ++i) spheres.push_back({{100.0 + 5 * i, 0, 0}, 1});
    const SphereSet set(spheres, search);
    Pcg32 random(11);
    for (int k = 0; k < 1000; ++k) {
      const Vec3d wall = random_direction(random);
      Vec3d outwards = random_direction(random);
      if (dot(outwards, wall) < 0) outwards = -outwards;
      const auto inside = set.next_wall(wall, -outwards, 0);
      ASSERT_TRUE(inside);
      EXPECT_EQ(inside->sphere, 0);
      EXPECT_EQ(inside->distance, 2 * dot(outwards, wall));
      const auto outside = set.next_wall(wall, outwards, 0);
      EXPECT_TRUE(!outside || outside->sphere != 0);
    }
  }
}

TEST(SphereSet, NothingToMeet) {
  EXPECT_FALSE(SphereSet({}).next_wall({}, {0, 0, 1}));
  const SphereSet set(scattered(30, 1, 0.1, 0.2, 12));
  EXPECT_FALSE(set.next_wall({0, 0, 10}, {0, 0, 1}));
  EXPECT_FALSE(set.next_wall({0, 5, 10}, {0, 0, -1}));
}

TEST(SphereSet, Moves) {
  SphereSet first(scattered(30, 1, 0.1, 0.2, 13));
  const Vec3d origin{0, 0, 10};
  const Vec3d direction = math::normalize(first.spheres()[5].center - origin);
  const auto hit = first.next_wall(origin, direction);
  ASSERT_TRUE(hit);
  SphereSet second(std::move(first));
  EXPECT_EQ(second.next_wall(origin, direction)->distance, hit->distance);
  SphereSet third({});
  third = std::move(second);
  EXPECT_EQ(third.next_wall(origin, direction)->distance, hit->distance);
  EXPECT_EQ(third.spheres().size(), 30u);
}

}  // namespace
}  // namespace shabon::geometry
