#include "shabon/math/vec.h"

#include <gtest/gtest.h>

#include "shabon/math/packet.h"

namespace shabon::math {
namespace {

TEST(Vec3, Calculates) {
  const Vec3d a{1, 2, 3}, b{-2, 0.5, 4};
  EXPECT_EQ(a + b, (Vec3d{-1, 2.5, 7}));
  EXPECT_EQ(a - b, (Vec3d{3, 1.5, -1}));
  EXPECT_EQ(2.0 * a, (Vec3d{2, 4, 6}));
  EXPECT_EQ(a * 2.0, 2.0 * a);
  EXPECT_EQ(-a, (Vec3d{-1, -2, -3}));
  EXPECT_EQ(dot(a, b), 11);
  EXPECT_EQ(length(Vec3d{2, 3, 6}), 7);
  EXPECT_EQ(normalize(Vec3d{0, 3, 4}), (Vec3d{0, 3 * (1.0 / 5), 4 * (1.0 / 5)}));
}

TEST(Vec3, CrossProductsAreRightHanded) {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
  EXPECT_EQ(cross(y, x), -z);
}

TEST(Vec3, HoldsPackets) {
  using Rays = packet<double, 8>;
  const double xs[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  const Vec3<Rays> v{Rays::load(xs), Rays(2.0), Rays(-1.0)};
  const Rays squared = dot(v, v), size = length(v), unit = length(normalize(v));
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(squared[i], xs[i] * xs[i] + 5);
    EXPECT_EQ(size[i], std::sqrt(xs[i] * xs[i] + 5));
    EXPECT_NEAR(unit[i], 1, 4e-16);
  }
}

}  // namespace
}  // namespace shabon::math
