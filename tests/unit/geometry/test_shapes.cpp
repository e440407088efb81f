// Every shape of the list: where rays meet it, against its equation, and what is there.
#include <array>
#include <optional>

#include "shabon/geometry/sphere.h"
#include "shape_cases.h"

namespace shabon::geometry {
namespace {

// Most carriers are, along a ray, polynomials of at most the second degree: here from three of their values.
struct Along {
  Real a, b, c;
};

template <class T>
Along carrier_along(const T& shape, const PlacedShape& placed, Vec3d origin, Vec3d direction) {
  const Vec3r o = solve(placed.to_world, real(origin)),
              d = solve({placed.to_world.x, placed.to_world.y, placed.to_world.z, {}}, real(direction));
  const Real c = Known<T>::carrier(shape, o), plus = Known<T>::carrier(shape, o + d),
             minus = Known<T>::carrier(shape, o - d);
  return {T::flat ? 0 : (plus + minus) / 2 - c, (plus - minus) / 2, c};
}

struct Expected {
  std::optional<Real> distance;
  bool doubtful = false;  // so near to an edge, or grazing so much, that rounding decides
};

template <class T>
requires(!requires { Known<T>::any_degree; }) Expected
    expected_crossing(const T& shape, const PlacedShape& placed, Vec3d origin, Vec3d direction, bool starts) {
  constexpr Real close = 1e-9L;
  const Along f = carrier_along(shape, placed, origin, direction);
  std::vector<Real> roots;
  Expected result;
  if (T::flat) {
    if (!starts) roots = {-f.c / f.b};
  } else if (starts) {
    roots = {-f.b / f.a};
  } else {
    const Real square = f.b * f.b - 4 * f.a * f.c;
    result.doubtful = std::abs(square) < close * f.b * f.b;
    if (square >= 0) roots = {(-f.b - std::sqrt(square)) / (2 * f.a), (-f.b + std::sqrt(square)) / (2 * f.a)};
  }
  for (const Real root : roots) {
    const Vec3r at = solve(placed.to_world, real(origin) + real(direction) * root);
    const Real edge = Known<T>::edge(shape, at);
    if (std::abs(edge) < close || std::abs(root) < close) result.doubtful = true;
    if (root > 0 && edge >= 0 && !result.distance) result.distance = root;
  }
  return result;
}

// Where the carrier is of any degree: its sign at many places along the ray, then halves.
template <class T>
requires Known<T>::any_degree Expected expected_crossing(const T& shape, const PlacedShape& placed, Vec3d origin,
                                                         Vec3d direction, bool starts) {
  constexpr int steps = 2000;
  const Vec3r o = solve(placed.to_world, real(origin)),
              d = solve({placed.to_world.x, placed.to_world.y, placed.to_world.z, {}}, real(direction));
  const auto height = [&](Real t) { return Known<T>::carrier(shape, o + d * t); };
  const Real first = starts ? 2e-6L / std::sqrt(dot(d, d)) : 0, middle = -dot(o, d) / dot(d, d),
             half = 2 / std::sqrt(dot(d, d));
  Expected result;
  Real before = std::max(first, middle - half), at_before = height(before), at_last = at_before;
  result.doubtful = !starts && std::abs(at_before) < 1e-9L;
  for (int k = 1; k <= steps && !result.distance; ++k) {
    const Real now = middle - half + 2 * half * k / steps;
    if (now <= before) continue;
    const Real at_now = height(now);
    if ((at_now > 0) != (at_before > 0)) {
      Real low = before, high = now;
      for (int i = 0; i < 70; ++i) ((height((low + high) / 2) > 0) == (at_before > 0) ? low : high) = (low + high) / 2;
      result.distance = high;
      const Real slope = (height(high + 1e-6L) - height(high - 1e-6L)) / 2e-6L;
      if (std::abs(slope) < 1e-5L * std::sqrt(dot(d, d))) result.doubtful = true;
    } else if (std::abs(at_before) < std::min({1e-5L, std::abs(at_last), std::abs(at_now)})) {
      result.doubtful = true;  // it may touch between two places
    }
    at_last = at_before, before = now, at_before = at_now;
  }
  return result;
}

template <class T>
void expect_crossing(const T& shape, const PlacedShape& placed, Vec3d origin, Vec3d direction, bool starts,
                     std::array<int, 3>& tally) {
  const Expected expected = expected_crossing(shape, placed, origin, direction, starts);
  const auto found = next_crossing(placed, origin, direction, starts);
  if (expected.doubtful) {
    ++tally[2];
    return;
  }
  ASSERT_EQ(found.has_value(), expected.distance.has_value());
  ++tally[found ? 0 : 1];
  if (found) {
    ASSERT_NEAR(*found, static_cast<double>(*expected.distance), 1e-9 * (size_of(placed) + *found));
  }
}

Vec3d between(const Box& box, Pcg32& random) {
  return {random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y),
          random.uniform(box.low.z, box.high.z)};
}

template <class T>
class EachShape : public testing::Test {};
TYPED_TEST_SUITE(EachShape, EveryShape);

TYPED_TEST(EachShape, IsMetWhereItsEquationSays) {
  std::array<int, 3> tally{};
  for_each_placed<TypeParam>(1, 6, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    for (int k = 0; k < 500; ++k) {
      const Vec3d target = between(placed.box, random);
      const double away = size_of(placed) * random.uniform(0.01, 4);
      const Vec3d origin = k % 4 == 0 ? between(placed.box, random) : target + random_direction(random) * away;
      expect_crossing(shape, placed, origin, math::normalize(target - origin), false, tally);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "ray " << k;
    }
  });
  EXPECT_GT(tally[0], 1000);
  EXPECT_GT(tally[1], 1000);
  EXPECT_LT(tally[2], 20);
}

TYPED_TEST(EachShape, IsLeftWithoutBeingMetAtOnce) {
  std::array<int, 3> tally{};
  for_each_placed<TypeParam>(2, 6, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    for (int k = 0; k < 500; ++k) {
      const Vec3d on_it = sample_area(placed, random.uniform(), random.uniform()).at.position;
      const Vec3d direction = random_direction(random);
      expect_crossing(shape, placed, on_it, direction, true, tally);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "ray " << k;
      ASSERT_FALSE(TypeParam::flat && next_crossing(placed, on_it, direction, true));
    }
  });
  EXPECT_LT(tally[2], 20);
}

TYPED_TEST(EachShape, SurfaceAtACrossing) {
  for_each_placed<TypeParam>(3, 3, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    const double size = size_of(placed);
    for (int k = 0; k < 200; ++k) {
      const Vec3d origin = placed.to_world.origin + random_direction(random) * (size * random.uniform(1, 100));
      const Vec3d direction = math::normalize(between(placed.box, random) - origin);
      const auto distance = next_crossing(placed, origin, direction, false);
      if (!distance) continue;
      const SurfacePoint at = surface_at(placed, origin, direction, *distance);
      const Vec3r p = solve(placed.to_world, real(at.position));
      ASSERT_NEAR(Known<TypeParam>::carrier(shape, p), 0, 1e-13);
      ASSERT_GE(Known<TypeParam>::edge(shape, p), -1e-10);
      ASSERT_NEAR(math::length(at.position - origin - direction * *distance), 0, 1e-11 * (size + *distance));
      const Vec3d uv =
          Known<TypeParam>::uv({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
      ASSERT_NEAR(at.u, uv.x, 1e-9);
      ASSERT_NEAR(at.v, uv.y, 1e-9);
    }
  });
}

// The normal is the gradient of the equation; along the tangent u rises and v does not change.
TYPED_TEST(EachShape, NormalsAndTangentsByFiniteDifferences) {
  for_each_placed<TypeParam>(4, 3, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    const double h = 1e-6 * size_of(placed);
    for (int k = 0; k < 100; ++k) {
      const SurfacePoint at = sample_area(placed, random.uniform(0.05, 0.95), random.uniform(0.05, 0.95)).at;
      const auto value = [&](Vec3d p) { return Known<TypeParam>::carrier(shape, solve(placed.to_world, real(p))); };
      const auto slope = [&](Vec3d e) {
        return static_cast<double>(value(at.position + e * h) - value(at.position - e * h));
      };
      const Vec3d gradient{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
      ASSERT_NEAR(math::length(math::normalize(gradient) - at.normal), 0, 1e-7);
      ASSERT_NEAR(math::length(at.normal), 1, 1e-14);
      ASSERT_NEAR(math::length(at.tangent_u), 1, 1e-14);
      ASSERT_NEAR(dot(at.normal, at.tangent_u), 0, 1e-12);
      const auto uv = [&](Vec3d p) {
        const Vec3r c = solve(placed.to_world, real(p));
        return Known<TypeParam>::uv({static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)});
      };
      const Vec3d change = uv(at.position + at.tangent_u * h) - uv(at.position - at.tangent_u * h);
      ASSERT_GT(change.x, 0);
      ASSERT_LT(std::abs(change.y), 1e-4 * change.x);
    }
  });
}

TYPED_TEST(EachShape, TheBoxIsTightAndHeightRunsOverIt) {
  for_each_placed<TypeParam>(5, 4, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    const Box box = bounds(placed);
    const double size = size_of(placed);
    constexpr double inf = std::numeric_limits<double>::infinity();
    Vec3d low{inf, inf, inf}, high = -low;
    constexpr int n = 200;
    for (int i = 0; i <= n; ++i)
      for (int k = 0; k <= n; ++k) {
        const Vec3d c = Known<TypeParam>::parametrized(shape, static_cast<double>(i) / n, static_cast<double>(k) / n);
        const Vec3d p = apply_point(placed.to_world, c);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    for (const auto& [found, expected] : {std::pair{box.low, low}, std::pair{box.high, high}}) {
      const double most = 1e-3 * size;
      ASSERT_NEAR(found.x, expected.x, most);
      ASSERT_NEAR(found.y, expected.y, most);
      ASSERT_NEAR(found.z, expected.z, most);
    }
    for (int k = 0; k < 200; ++k) {
      const SurfacePoint at = sample_area(placed, random.uniform(), random.uniform()).at;
      const double ulp = 1e-13 * (size + math::length(placed.to_world.origin));
      ASSERT_GE(at.position.x, box.low.x - ulp);
      ASSERT_LE(at.position.x, box.high.x + ulp);
      ASSERT_GE(at.position.z, box.low.z - ulp);
      ASSERT_LE(at.position.z, box.high.z + ulp);
      ASSERT_LE(std::abs(at.from_centre.y), 1 + 1e-12);
      Vec3d expected = (at.position - (box.low + box.high) * 0.5) * (2 / (box.high.y - box.low.y));
      if constexpr (requires { TypeParam::by_direction; })
        expected = math::normalize(at.position - placed.to_world.origin);
      ASSERT_NEAR(math::length(at.from_centre - expected), 0, 1e-10 * math::length(expected) + 1e-10);
    }
  });
}

// Rays in the plane of a shape, along its edges, through its corners and its axis, and tangents.
TYPED_TEST(EachShape, RaysAlongEdgesAreNeverNaN) {
  const Affine maps[] = {{}, placement({1, 2, 3}, {90, 0, 0}, {2, 2, 2}), placement({}, {0, 90, 180}, {1, 0.5, 2})};
  const double places[] = {-2, -1, -0.5, 0, 0.5, 1, 2}, steps[] = {-1, 0, 1};
  const auto is_fine = [](Vec3d v) { return std::isfinite(v.x + v.y + v.z); };
  const auto check = [&](const PlacedShape& placed, Vec3d origin, Vec3d direction, bool starts) {
    const auto distance = next_crossing(placed, origin, direction, starts);
    if (!distance) return;
    ASSERT_TRUE(*distance > 0 && std::isfinite(*distance));
    const SurfacePoint at = surface_at(placed, origin, direction, *distance);
    ASSERT_TRUE(is_fine(at.position) && is_fine(at.from_centre) && std::isfinite(at.u + at.v));
    ASSERT_NEAR(math::length(at.normal), 1, 1e-12);
    ASSERT_NEAR(math::length(at.tangent_u), 1, 1e-12);
    const double pdf = pdf_toward(placed, origin, direction, *distance);
    ASSERT_TRUE(pdf >= 0 && std::isfinite(pdf));
  };
  for (const TypeParam& shape : Known<TypeParam>::examples())
    for (const Affine& map : maps) {
      const PlacedShape placed = place(shape, map);
      for (const double x : places)
        for (const double y : places)
          for (const double z : places) {
            const Vec3d origin = apply_point(map, {x, y, z});
            for (int k = 0; k < 27; ++k) {
              if (k == 13) continue;
              const Vec3d step{steps[k % 3], steps[k / 3 % 3], steps[k / 9]};
              const Vec3d direction = math::normalize(apply_vector(map, step));
              check(placed, origin, direction, false);
              check(placed, origin, direction, true);
              ASSERT_FALSE(testing::Test::HasFatalFailure());
            }
            for (const double u : {0.0, 0.25, 0.5, 1 - 0x1p-53})
              for (const double w : {0.0, 0.25, 0.5, 1 - 0x1p-53})
                if (const auto toward = sample_toward(placed, origin, u, w)) {
                  ASSERT_TRUE(is_fine(toward->direction) && toward->distance >= 0);
                  ASSERT_TRUE(toward->pdf > 0 && std::isfinite(toward->pdf));
                }
          }
    }
}

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
