#include "shabon/geometry/coincidence.h"

#include "shape_cases.h"

namespace shabon::geometry {
namespace {

using Shapes = std::vector<PlacedShape>;
using Pairs = std::vector<std::pair<int, int>>;
const Pairs first_two{{0, 1}};

template <class T>
class EachShapeTwice : public testing::Test {};
TYPED_TEST_SUITE(EachShapeTwice, EveryShape);

PlacedShape moved(const PlacedShape& shape, Vec3d by) {
  Affine map = shape.to_world;
  map.origin = map.origin + by;
  return place(shape.shape, map);
}

TYPED_TEST(EachShapeTwice, LiesOnItselfAndNotOnItsNeighbour) {
  for_each_placed<TypeParam>(41, 4, [&](const TypeParam&, const PlacedShape& placed, Pcg32& random) {
    const double size = size_of(placed);
    EXPECT_EQ(coincident(Shapes{placed, placed}), first_two);
    EXPECT_EQ(coincident(Shapes{placed, moved(placed, random_direction(random) * (1e-13 * size))}), first_two);
    const Vec3d normal = sample_area(placed, 0.3, 0.7).at.normal;
    EXPECT_TRUE(coincident(Shapes{placed, moved(placed, normal * (1e-6 * size))}).empty());
    EXPECT_TRUE(coincident(Shapes{placed, moved(placed, random_direction(random) * (1.01 * size))}).empty());
    Affine larger = placed.to_world;  // grown across its surface, or turned out of its plane
    if (TypeParam::flat)
      larger.x = larger.x + larger.z * 1e-5;
    else
      larger.x = larger.x * (1 + 1e-5), larger.z = larger.z * (1 + 1e-5);
    EXPECT_TRUE(coincident(Shapes{placed, place(placed.shape, larger)}).empty());
  });
}

TEST(Coincidence, SymmetriesDoNotHideIt) {
  const auto pair = [](const Shape& a, const Affine& m, const Shape& b, const Affine& n) {
    return coincident(Shapes{place(a, m), place(b, n)}).size() == 1;
  };
  const Vec3d at{1, 2, 3};
  EXPECT_TRUE(pair(SphereCap{}, placement(at, {}, {2, 2, 2}), SphereCap{}, placement(at, {40, 50, 60}, {2, -2, 2})));
  // The same ellipsoid, its axes named otherwise.
  EXPECT_TRUE(pair(SphereCap{}, placement(at, {}, {1, 2, 3}), SphereCap{}, placement(at, {0, 90, 0}, {3, 2, 1})));
  EXPECT_FALSE(pair(SphereCap{}, placement(at, {}, {1, 2, 3}), SphereCap{}, placement(at, {0, 90, 0}, {1, 2, 3})));
  EXPECT_TRUE(pair(Cylinder{}, placement(at, {30, 0, 0}), Cylinder{},
                   compose(placement(at, {30, 0, 0}), placement({}, {0, 77, 180}))));
  EXPECT_TRUE(pair(Torus{0.2}, placement(at, {30, 0, 0}), Torus{0.2},
                   compose(placement(at, {30, 0, 0}), placement({}, {0, 77, 180}))));
  EXPECT_FALSE(pair(Torus{0.2}, placement(at, {30, 0, 0}), Torus{0.21}, placement(at, {30, 0, 0})));
  EXPECT_FALSE(pair(Torus{0.2}, placement(at, {30, 0, 0}), Torus{0.2}, placement(at, {31, 0, 0})));
  // A level quad seen from below, of another size, and a disk on it.
  EXPECT_TRUE(pair(Quad{}, placement(at, {90, 0, 0}, {2, 2, 2}), Quad{}, placement(at, {-90, 33, 0}, {1, 1, 1})));
  EXPECT_TRUE(pair(Quad{}, placement(at, {90, 0, 0}, {2, 2, 2}), Disk{}, placement(at, {-90, 33, 0}, {1, 1, 1})));
  EXPECT_FALSE(pair(Quad{}, placement(at, {90, 0, 0}), Disk{}, placement(at, {90, 10, 1})));  // they cross
}

TEST(Coincidence, HalvesOfOneSphereOnlyTouch) {
  const PlacedShape up = place(SphereCap{0}, {}), down = place(SphereCap{0}, placement({}, {180, 0, 0}));
  EXPECT_TRUE(coincident(Shapes{up, down}).empty());
  EXPECT_EQ(coincident(Shapes{up, place(SphereCap{0}, placement({}, {179, 0, 0}))}), first_two);
  EXPECT_EQ(coincident(Shapes{down, place(SphereCap{-0.1}, {})}), first_two);
  EXPECT_EQ(coincident(Shapes{down, place(SphereCap{}, {})}), first_two);
}

TEST(Coincidence, TubesEndToEndOnlyTouch) {
  const PlacedShape tube = place(Cylinder{}, {});
  EXPECT_TRUE(coincident(Shapes{tube, place(Cylinder{}, placement({0, 3, 0}, {}, {1, 2, 1}))}).empty());
  EXPECT_EQ(coincident(Shapes{tube, place(Cylinder{}, placement({0, 2.9, 0}, {}, {1, 2, 1}))}), first_two);
}

TEST(Coincidence, TilesAndRingsThatTouchAreNone) {
  Shapes tiles;
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k) tiles.push_back(place(Quad{}, placement({0.2 * i, 0.2 * k, 7}, {}, {0.1, 0.1, 1})));
  EXPECT_TRUE(coincident(tiles).empty());
  tiles.push_back(place(Triangle{}, placement({0.15, 0.15, 7}, {}, {0.1, 0.1, 0.1})));
  EXPECT_EQ(coincident(tiles), (Pairs{{6, 25}}));
  const PlacedShape ring = place(Disk{0.5}, {});
  EXPECT_TRUE(coincident(Shapes{ring, place(Disk{}, placement({}, {}, {0.5, 0.5, 1}))}).empty());
  EXPECT_EQ(coincident(Shapes{ring, place(Disk{}, placement({}, {}, {0.51, 0.51, 1}))}), first_two);
  EXPECT_EQ(coincident(Shapes{ring, place(Quad{}, placement({0.4, 0, 0}, {}, {0.2, 0.2, 1}))}), first_two);
  EXPECT_TRUE(coincident(Shapes{ring, place(Quad{}, placement({}, {}, {0.3, 0.3, 1}))}).empty());
  const PlacedShape beside = place(Disk{}, placement({std::sqrt(2.0) * 1.001, std::sqrt(2.0) * 1.001, 0}));
  EXPECT_TRUE(coincident(Shapes{place(Disk{}, {}), beside}).empty());  // their boxes overlap
}

TEST(Coincidence, EveryPairIsNamedOnce) {
  const PlacedShape a = place(Quad{}, {}), b = place(SphereCap{}, {});
  EXPECT_EQ(coincident(Shapes{a, b, a, b, a}), (Pairs{{0, 2}, {0, 4}, {1, 3}, {2, 4}}));
  EXPECT_TRUE(coincident(Shapes{}).empty());
}

}  // namespace
}  // namespace shabon::geometry
