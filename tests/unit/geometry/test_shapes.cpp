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

}  // namespace
}  // namespace shabon::geometry
