#include "shabon/geometry/affine.h"

#include <gtest/gtest.h>

#include "random_rays.h"

namespace shabon::geometry {
namespace {

using math::Vec3d;

void expect_near(Vec3d a, Vec3d b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

Affine random_affine(Pcg32& random) {
  return {random_point(random, 2), random_point(random, 2), random_point(random, 2), random_point(random, 5)};
}

TEST(Affine, PlacementScalesThenTurnsAboutTheWorldsAxesThenMoves) {
  const Vec3d position{1, 2, 3}, p{1, 0, 0};
  expect_near(apply_point(placement(position, {40, 90, 0}, {2, 3, 4}), p), position + Vec3d{0, 0, -2}, 0);
  expect_near(apply_point(placement({}, {90, 90, 0}), {0, 1, 0}), {1, 0, 0}, 0);  // y to z about x, z to x about y
  expect_near(apply_point(placement({}, {90, 0, 90}), {0, 1, 0}), {0, 0, 1}, 0);  // y to z; z stays about z
  expect_near(apply_point(placement({}, {0, 90, 90}), {0, 0, 1}), {0, 1, 0}, 0);  // z to x about y, x to y about z
  expect_near(apply_point(placement({}, {0, 0, 30}), {1, 0, 0}), {std::sqrt(3.0) / 2, 0.5, 0}, 1e-15);
  expect_near(apply_point(placement({}, {30, 0, 0}), {0, 1, 0}), {0, std::sqrt(3.0) / 2, 0.5}, 1e-15);
  expect_near(apply_point(placement({}, {0, 30, 0}), {0, 0, 1}), {0.5, 0, std::sqrt(3.0) / 2}, 1e-15);
}

TEST(Affine, QuarterTurnsAreExact) {
  for (int k = -9; k <= 9; ++k) {
    const auto [c, s] = turn_by(90.0 * k);
    EXPECT_EQ(c, (k % 2 != 0) ? 0 : (k % 4 == 0 ? 1 : -1)) << k;
    EXPECT_EQ(s, (k % 2 == 0) ? 0 : ((k - 1) % 4 == 0 ? 1 : -1)) << k;
  }
  for (double angle = -1000; angle < 1000; angle += 0.37) {
    const auto [c, s] = turn_by(angle);
    EXPECT_NEAR(c, std::cos(angle * std::numbers::pi / 180), 1e-14);
    EXPECT_NEAR(s, std::sin(angle * std::numbers::pi / 180), 1e-14);
  }
}

TEST(Affine, TurnsKeepLengthsAndHandedness) {
  Pcg32 random(1);
  for (int k = 0; k < 100; ++k) {
    const Affine turn = placement(random_point(random, 9), random_point(random, 400));
    EXPECT_NEAR(determinant(turn), 1, 1e-14);
    const Vec3d v = random_point(random, 1);
    EXPECT_NEAR(math::length(apply_vector(turn, v)), math::length(v), 1e-14);
    EXPECT_NEAR(determinant(placement({}, random_point(random, 400), {2, -3, 4})), -24, 1e-12);
  }
}

TEST(Affine, InverseAndComposition) {
  Pcg32 random(2);
  for (int k = 0; k < 200; ++k) {
    const Affine a = random_affine(random), b = random_affine(random);
    if (std::abs(determinant(a)) < 0.1) continue;
    const Vec3d p = random_point(random, 3);
    expect_near(apply_point(inverse(a), apply_point(a, p)), p, 1e-12);
    expect_near(apply_point(a, apply_point(inverse(a), p)), p, 1e-11);
    expect_near(apply_point(compose(a, b), p), apply_point(a, apply_point(b, p)), 1e-13);
    EXPECT_NEAR(dot(apply_transposed(a, p), Vec3d{1, 2, 3}), dot(p, apply_vector(a, {1, 2, 3})), 1e-12);
  }
}

TEST(Affine, NormalsStayAcrossAndOutward) {
  Pcg32 random(3);
  for (int k = 0; k < 200; ++k) {
    const Affine a = random_affine(random);
    const Vec3d n = random_direction(random), v = random_direction(random);
    const Vec3d t1 = math::normalize(cross(n, v)), t2 = cross(n, t1);
    const Vec3d mapped = apply_normal(a, n);
    EXPECT_NEAR(math::length(mapped), 1, 1e-15);
    EXPECT_NEAR(dot(mapped, apply_vector(a, t1)), 0, 1e-13);
    EXPECT_NEAR(dot(mapped, apply_vector(a, t2)), 0, 1e-13);
    EXPECT_GT(dot(mapped, apply_vector(a, n)), 0);
    const double grown = math::length(cross(apply_vector(a, t1), apply_vector(a, t2)));
    EXPECT_NEAR(math::length(apply_area_vector(a, n)), grown, 1e-12);
  }
}

}  // namespace
}  // namespace shabon::geometry
