#include "shabon/geometry/shape_set.h"

#include <atomic>

#include "shabon/base/parallel.h"
#include "shape_cases.h"

namespace shabon::geometry {
namespace {

using Shapes = std::vector<PlacedShape>;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Every example of every shape of the list, `rounds` times.
template <class... T>
Shapes scattered(std::variant<T...>*, Pcg32& random, int rounds, double reach, double size, Vec3d center = {}) {
  Shapes shapes;
  const auto add = [&](const auto& shape) {
    for (const MapKind kind : map_kinds) {
      Affine map = random_map(random, kind, 0);
      map = {map.x * size, map.y * size, map.z * size, center + random_point(random, reach)};
      shapes.push_back(place(shape, map));
    }
  };
  for (int k = 0; k < rounds; ++k)
    (
        [&] {
          for (const T& shape : Known<T>::examples()) add(shape);
        }(),
        ...);
  return shapes;
}

Shapes scattered(std::uint64_t seed, int rounds, double reach, double size, Vec3d center = {}) {
  Pcg32 random(seed);
  return scattered(static_cast<Shape*>(nullptr), random, rounds, reach, size, center);
}

struct Both {
  ShapeSet one_by_one, tree;
  explicit Both(const Shapes& shapes) : one_by_one(shapes, ShapeSearch::one_by_one), tree(shapes, ShapeSearch::tree) {}

  // Follows a ray through everything it crosses. The number of crossings.
  int compare(Vec3d origin, Vec3d direction, double limit = infinity) const {
    int from = no_shape, crossings = 0;
    for (; crossings < 12; ++crossings) {
      const auto expected = one_by_one.next(origin, direction, from, limit);
      const auto found = tree.next(origin, direction, from, limit);
      EXPECT_EQ(found.has_value(), expected.has_value());
      if (!found || !expected) break;
      EXPECT_EQ(found->shape, expected->shape);
      EXPECT_EQ(found->distance, expected->distance);
      EXPECT_LT(found->distance, limit);
      origin = surface_at(tree.shapes()[static_cast<std::size_t>(found->shape)], origin, direction, found->distance)
                   .position;
      from = found->shape;
    }
    return crossings;
  }
};

void expect_same(const Shapes& shapes, Vec3d center, double reach, int rays, std::uint64_t seed) {
  const Both both(shapes);
  Pcg32 random(seed);
  int crossings = 0;
  for (int k = 0; k < rays && !testing::Test::HasFailure(); ++k) {
    const double limit = k % 3 == 0 ? reach * random.uniform(0, 3) : infinity;
    crossings += both.compare(center + random_point(random, reach), random_direction(random), limit);
  }
  EXPECT_GT(crossings, rays / 2);
}

TEST(ShapeSet, TheTreeAndOneByOneAgree) {
  const Shapes shapes = scattered(21, 3, 5, 0.7);
  EXPECT_GT(shapes.size(), 100u);
  expect_same(shapes, {}, 6, 6000, 21);
}

TEST(ShapeSet, AFewInATree) { expect_same(scattered(22, 1, 1.5, 0.5), {}, 2, 4000, 22); }

TEST(ShapeSet, FarFromTheOrigin) {
  const Vec3d far{1e6, -2e6, 3e6};
  expect_same(scattered(23, 2, 5, 0.7, far), far, 6, 3000, 23);
}

TEST(ShapeSet, OfAnySize) {
  for (const double scale : {1e-20, 1e-6, 1e6, 1e20})
    expect_same(scattered(24, 1, 3 * scale, 0.7 * scale), {}, 4 * scale, 2000, 24);
}

TEST(ShapeSet, SeenFromFarAway) {
  const Both both(scattered(25, 2, 5, 0.7));
  Pcg32 random(25);
  int crossings = 0;
  for (const double distance : {1e2, 1e4, 1e6, 1e8})
    for (int k = 0; k < 1000; ++k) {
      const Vec3d origin = random_direction(random) * distance;
      const double limit = k % 2 == 0 ? infinity : distance + random.uniform(-8, 8);
      crossings += both.compare(origin, math::normalize(random_point(random, 4) - origin), limit);
    }
  EXPECT_GT(crossings, 3000);
}

TEST(ShapeSet, SmallOnesOnAWideFloor) {
  Shapes shapes = scattered(26, 1, 5, 0.5);
  shapes.push_back(place(Quad{}, placement({0, -3, 0}, {-90, 0, 0}, {1e5, 1e5, 1})));
  expect_same(shapes, {}, 6, 3000, 26);
}

// Level walls, and boxes without depth, whose corners and edges rays go through.
TEST(ShapeSet, ARoomOfTiles) {
  Shapes shapes;
  for (int side = 0; side < 3; ++side)
    for (const double at : {-2.0, 2.0})
      for (int i = -2; i < 2; ++i)
        for (int k = -2; k < 2; ++k) {
          const Vec3d turns_deg[] = {{0, 90, 0}, {90, 0, 0}, {0, 0, 0}};
          const Vec3d centers[] = {{at, i + 0.5, k + 0.5}, {i + 0.5, at, k + 0.5}, {i + 0.5, k + 0.5, at}};
          shapes.push_back(place(Quad{}, placement(centers[side], turns_deg[side], {0.5, 0.5, 1})));
        }
  const Both both(shapes);
  Pcg32 random(27);
  for (int k = 0; k < 3000; ++k) {
    const Vec3d inside = random_point(random, 1.99), direction = random_direction(random);
    EXPECT_TRUE(both.one_by_one.next(inside, direction));
    both.compare(inside, direction);
  }
  for (int i = -2; i <= 2; ++i)  // through corners and along edges
    for (int k = -2; k <= 2; ++k)
      for (const Vec3d direction : {Vec3d{1, 0, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, 1}}) {
        both.compare(Vec3d{1.0 * i, 1.0 * k, 0} - direction * 7.0, direction);
        both.compare({0.5 * i, 0.5 * k, 0.5 * i}, direction);
      }
}

TEST(ShapeSet, EqualDistancesGoByTheList) {
  const PlacedShape wall = place(Quad{}, placement({1, 2, 3}, {20, 30, 40}, {2, 2, 1}));
  const Both both(Shapes(12, wall));
  Pcg32 random(28);
  for (int k = 0; k < 500; ++k) {
    const Vec3d target = sample_area(wall, random.uniform(), random.uniform()).at.position;
    const Vec3d origin = target + random_direction(random) * 3.0;
    for (const ShapeSet* set : {&both.one_by_one, &both.tree}) {
      const auto hit = set->next(origin, math::normalize(target - origin));
      EXPECT_TRUE(!hit || hit->shape == 0);
      const auto next = set->next(target, math::normalize(target - origin), 0);
      EXPECT_TRUE(!next || next->shape != 0);
    }
  }
}

TEST(ShapeSet, TheLimitIsNotMet) {
  const Both both({place(Quad{}, placement({0, 0, -2}))});
  for (const ShapeSet* set : {&both.one_by_one, &both.tree}) {
    EXPECT_FALSE(set->next({}, {0, 0, -1}, no_shape, 2));
    EXPECT_TRUE(set->next({}, {0, 0, -1}, no_shape, std::nextafter(2.0, 3.0)));
    EXPECT_FALSE(set->next({}, {0, 0, -1}, no_shape, 0));
    EXPECT_FALSE(set->next({0, 0, 100}, {0, 0, -1}, no_shape, 50));
  }
}

TEST(ShapeSet, TheNumberDecidesHowShapesAreFound) {
  for (const int count : {ShapeSet::few, ShapeSet::few + 1}) {
    const ShapeSet set(Shapes(static_cast<std::size_t>(count), place(Quad{}, {})));
    EXPECT_EQ(set.has_few(), count <= ShapeSet::few);
  }
  EXPECT_FALSE(ShapeSet({}).next({}, {0, 0, 1}));
  EXPECT_FALSE(ShapeSet({}, ShapeSearch::tree).next({}, {0, 0, 1}));
}

TEST(ShapeSet, ThreadsMayAskAtTheSameTime) {
  const Both both(scattered(29, 2, 5, 0.7));
  std::atomic<int> different = 0, hits = 0;
  parallel_for(64, 4, [&](std::size_t block) {
    Pcg32 random(block);
    for (int k = 0; k < 100; ++k) {
      const Vec3d origin = random_point(random, 6), direction = random_direction(random);
      const auto a = both.one_by_one.next(origin, direction), b = both.tree.next(origin, direction);
      if (a.has_value() != b.has_value() || (a && (a->shape != b->shape || a->distance != b->distance))) ++different;
      if (a) ++hits;
    }
  });
  EXPECT_EQ(different, 0);
  EXPECT_GT(hits, 2000);
}

TEST(ShapeSet, Moves) {
  ShapeSet first(scattered(30, 1, 3, 0.7), ShapeSearch::tree);
  const Vec3d origin{0, 0, 20};
  const Vec3d target = sample_area(first.shapes()[5], 0.4, 0.4).at.position;
  const Vec3d direction = math::normalize(target - origin);
  const auto hit = first.next(origin, direction);
  ASSERT_TRUE(hit);
  ShapeSet second(std::move(first));
  EXPECT_EQ(second.next(origin, direction)->distance, hit->distance);
  ShapeSet third({});
  third = std::move(second);
  EXPECT_EQ(third.next(origin, direction)->shape, hit->shape);
}

}  // namespace
}  // namespace shabon::geometry
