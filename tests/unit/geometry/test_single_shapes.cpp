// What is particular to one shape.
#include "shabon/geometry/sphere.h"
#include "shape_cases.h"

namespace shabon::geometry {
namespace {

TEST(Sphere, WholeRoundOnesAreTheBubblesOwn) {
  Pcg32 random(6);
  for (int k = 0; k < 2000; ++k) {
    const SphereShape sphere{random_point(random, 5), random.uniform(0.1, 3)};
    const double r = sphere.radius;
    const PlacedShape placed = place(SphereCap{}, placement(sphere.center, {}, {r, r, r}));
    const Vec3d wall = sphere.center + random_direction(random) * r, direction = random_direction(random);
    const double across = chord(wall, direction, sphere.center);
    const auto found = next_crossing(placed, wall, direction, true);
    ASSERT_EQ(found.has_value(), across > 0);
    ASSERT_EQ(found.value_or(across), across);
    const SurfacePoint at = sample_area(placed, random.uniform(), random.uniform()).at;
    ASSERT_NEAR(math::length(at.from_centre - at.normal), 0, 1e-15);
    ASSERT_NEAR(math::length(at.position - sphere.center - at.normal * r), 0, 1e-14);
  }
}

// A hair is met where a wire is: to the same share of its own thickness, from near and far, from outside and within.
TEST(Torus, IsMetHoweverThin) {
  Pcg32 random(33);
  for (const double tube : {0.1, 1e-3, 1e-6}) {
    const Torus torus{tube};
    const double most = 1e-9 * tube + 1e-15;
    const auto off = [&](Vec3d p) { return static_cast<double>(Known<Torus>::carrier(torus, real(p))); };
    for (int k = 0; k < 3000; ++k) {
      const Vec3d line = sample(Torus{0}, 0, random.uniform());  // on the middle line
      const Vec3d target = line + random_direction(random) * (tube * random.uniform(0, 0.9));
      const Vec3d direction = random_direction(random), origin = target - direction * random.uniform(0.01, 3);
      if (off(origin) < 0) continue;
      const auto in = next_crossing(torus, origin, direction, false);
      ASSERT_TRUE(in);
      const Vec3d entry = origin + direction * *in, on_it = point_at(torus, entry).position;
      ASSERT_NEAR(off(entry), 0, most);
      ASSERT_NEAR(math::length(entry - on_it), 0, 2 * most);
      if (off((entry + target) * 0.5) > 0) continue;  // another part of the ring lies before
      const auto out = next_crossing(torus, on_it, direction, true);
      ASSERT_TRUE(out);
      ASSERT_NEAR(off(on_it + direction * *out), 0, most);
      ASSERT_LT(math::length(on_it + direction * (*out / 2) - line), 2.5 * std::sqrt(tube));
    }
  }
}

// Without lobes, and with ones too small to count, it is the sphere.
TEST(LobedSphere, IsASphereWithoutLobes) {
  Pcg32 random(31);
  for (const double amplitude : {0.0, 1e-15, 1e-9}) {
    const LobedSphere lobed{1, {{2, amplitude, {0, 0.6, 0.8}}, {7, amplitude, {1, 0, 0}}}};
    const double most = 1e-13 + 30 * amplitude;
    const Affine map = placement({1, 2, 3}, {10, 20, 30}, {2, 2, 2});
    const PlacedShape sphere = place(SphereCap{}, map), placed = place(lobed, map);
    EXPECT_NEAR(area(placed), area(sphere), most * area(sphere));
    int grazing = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec3d from = map.origin + random_direction(random) * random.uniform(0, 9);
      const Vec3d direction = math::normalize(map.origin + random_point(random, 2) - from);
      const double impact = math::length(cross(from - map.origin, direction)) / 2;
      if (std::abs(impact - 1) < 1e-3 && ++grazing > 0) continue;
      const auto found = next_crossing(placed, from, direction, false),
                 expected = next_crossing(sphere, from, direction, false);
      ASSERT_EQ(found.has_value(), expected.has_value());
      if (!found) continue;
      ASSERT_NEAR(*found, *expected, 200 * most);
      const SurfacePoint at = surface_at(placed, from, direction, *found),
                         on = surface_at(sphere, from, direction, *found);
      ASSERT_NEAR(math::length(at.position - on.position), 0, 10 * most);
      ASSERT_NEAR(math::length(at.normal - on.normal), 0, 10 * most);
      const auto next = next_crossing(placed, at.position, direction, true),
                 chord = next_crossing(sphere, on.position, direction, true);
      ASSERT_EQ(next.has_value(), chord.has_value());
      if (next) {
        ASSERT_NEAR(*next, *chord, 200 * most);
      }
    }
    EXPECT_LT(grazing, 100);
  }
}

// However shallow a ray sets out inwards, it meets the far wall: on a convex surface where the osculating circle says.
TEST(LobedSphere, IsLeftByEveryRayWithin) {
  Pcg32 random(32);
  for (const LobedSphere& lobed : Known<LobedSphere>::examples()) {
    const PlacedShape placed = place(lobed, placement({5, -3, 2}, {}, {0.1, 0.1, 0.1}));
    for (int k = 0; k < 20000; ++k) {
      const SurfacePoint at = sample_area(placed, random.uniform(), random.uniform()).at;
      const double inwards = std::pow(10.0, random.uniform(-11, 0));
      const Vec3d along = math::normalize(cross(at.normal, random_direction(random)));
      const Vec3d direction = math::normalize(along - at.normal * inwards);
      const auto found = next_crossing(placed, at.position, direction, true);
      if (inwards > 1e-6) {
        ASSERT_TRUE(found) << inwards;
      }
      if (!found) continue;  // the surface bends away outwards, or rounding decides
      const SurfacePoint wall = surface_at(placed, at.position, direction, *found);
      ASSERT_LT(math::length(wall.position - at.position - direction * *found), 1e-14);
      // From the wall outwards it is not met again but where it is hollow.
      Vec3d origin = wall.position;
      int crossings = 1;
      while (const auto more = next_crossing(placed, origin, direction, true)) {
        origin = surface_at(placed, origin, direction, *more).position;
        ASSERT_LT(++crossings, 20);
      }
      if (inwards > 1e-6) {
        ASSERT_EQ(crossings % 2, 1) << inwards;
      }
    }
  }
}

TEST(Sphere, SpheresAreAlikeFarFromTheOrigin) {
  Pcg32 random(7);
  const Vec3d far{1e7, -3e7, 2e7};
  for (const Vec3d scale : {Vec3d{1, 1, 1}, Vec3d{1, 1.7, 0.6}}) {
    const PlacedShape near = place(SphereCap{}, placement({}, {10, 20, 30}, scale));
    const PlacedShape moved = place(SphereCap{}, placement(far, {10, 20, 30}, scale));
    for (int k = 0; k < 500; ++k) {
      const Vec3d from = random_direction(random) * 4.0, direction = math::normalize(random_point(random, 0.2) - from);
      const Vec3d origin = far + from;
      const auto here = next_crossing(near, origin - far, direction, false);
      const auto there = next_crossing(moved, origin, direction, false);
      ASSERT_TRUE(here && there);
      ASSERT_NEAR(*here, *there, 1e-14);
    }
  }
}

TEST(Flat, HeightOfALevelOneIsInItsLongestHalf) {
  const PlacedShape floor = place(Quad{}, placement({0, -1, 0}, {-90, 30, 0}, {5, 2, 1}));
  double longest = 0;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) {
      const SurfacePoint at = sample_area(floor, x, y).at;
      EXPECT_NEAR(at.from_centre.y, 0, 1e-15);
      EXPECT_NEAR(at.normal.y, 1, 1e-15);
      longest = std::max(longest, std::abs(dot(at.from_centre, math::normalize(floor.to_world.x))));
    }
  EXPECT_NEAR(longest, 1, 1e-14);
}

TEST(Triangle, CornersGoWhereTheyAreAsked) {
  const Vec3d a{1, 2, 3}, b{2, 2, 5}, c{0, 4, 1};
  const Affine map = triangle_placement(a, b, c);
  EXPECT_EQ(apply_point(map, {0, 0, 0}), a);
  EXPECT_NEAR(math::length(apply_point(map, {1, 0, 0}) - b), 0, 1e-15);
  EXPECT_NEAR(math::length(apply_point(map, {0, 1, 0}) - c), 0, 1e-15);
  const Vec3d across = math::normalize(cross(b - a, c - a));
  EXPECT_NEAR(dot(sample_area(place(Triangle{}, map), 0.5, 0.5).at.normal, across), 1, 1e-15);
}
}  // namespace
}  // namespace shabon::geometry
