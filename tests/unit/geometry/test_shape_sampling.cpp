// Every shape of the list: random points and directions against sums that know nothing of them.
#include "shape_cases.h"

namespace shabon::geometry {
namespace {

template <class T>
class EachShapeAtRandom : public testing::Test {};
TYPED_TEST_SUITE(EachShapeAtRandom, EveryShape);

double some_function(Vec3d p) { return 1.5 + std::sin(1.3 * p.x + 0.4) * std::cos(0.9 * p.y) + 0.3 * p.z * p.x; }

// The estimate from sampled points equals the sum over a fine net: the density is right, and so is the area.
TYPED_TEST(EachShapeAtRandom, SampledPointsIntegrateOverTheSurface) {
  constexpr int n = 160;
  for_each_placed<TypeParam>(11, 2, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    double sum = 0, total = 0, most = 0;
    for_each_facet(shape, placed.to_world, 400, [&](Vec3d p, double a) {
      sum += some_function(p) * a, total += a, most = std::max(most, std::abs(some_function(p)));
    });
    double estimate = 0, estimated_area = 0;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double u1 = (i + random.uniform()) / n, u2 = (k + random.uniform()) / n;
        const SampledPoint point = sample_area(placed, u1, u2);
        ASSERT_NEAR(Known<TypeParam>::carrier(shape, solve(placed.to_world, real(point.at.position))), 0, 1e-13);
        ASSERT_GE(Known<TypeParam>::edge(shape, solve(placed.to_world, real(point.at.position))), -1e-12);
        estimate += some_function(point.at.position) / point.pdf_area / (n * n);
        estimated_area += 1 / point.pdf_area / (n * n);
      }
    ASSERT_NEAR(area(placed), total, 3e-4 * total);
    ASSERT_NEAR(estimated_area, total, 1e-3 * total);
    ASSERT_NEAR(estimate, sum, 1e-3 * total * most);
  });
}

struct Sum {
  double total = 0, squares = 0;
  Vec3d weighted;                                          // by the direction
  double deviation() const { return std::sqrt(squares); }  // of independent directions; these are stratified: too much
};

// Of pdf_toward() over all directions, with every crossing of each.
Sum sum_over_directions(const PlacedShape& placed, Vec3d from, Vec3d axis, double one_minus_cos, int n, Pcg32& random) {
  const Vec3d s = math::normalize(cross(axis, std::abs(axis.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  const Vec3d t = cross(axis, s);
  const double each = 2 * std::numbers::pi * one_minus_cos / n / n;
  Sum sum;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double rest = one_minus_cos * (i + random.uniform()) / n, r = std::sqrt(rest * (2 - rest));
      const double phi = 2 * std::numbers::pi * (k + random.uniform()) / n;
      const Vec3d direction = math::normalize(axis * (1 - rest) + s * (r * std::cos(phi)) + t * (r * std::sin(phi)));
      Vec3d origin = from;
      double before = 0;
      bool starts = false;
      while (const auto distance = next_crossing(placed, origin, direction, starts)) {
        const double pdf = pdf_toward(placed, from, direction, before + *distance);
        sum.total += pdf * each, sum.squares += pdf * each * pdf * each;
        sum.weighted = sum.weighted + direction * (pdf * each);
        before += *distance, starts = true;
        origin = surface_at(placed, origin, direction, *distance).position;
      }
    }
  return sum;
}

// A direction from which the shape is seen, if it is flat not edge-on.
Vec3d random_view(const PlacedShape& placed, bool flat, Pcg32& random) {
  const Vec3d normal = apply_normal(placed.to_world, {0, 0, 1});
  for (;;)
    if (const Vec3d axis = random_direction(random); !flat || std::abs(dot(axis, normal)) > 0.3) return axis;
}

// The sums may be off by four of their deviations, which are 2 % on average and 10 % at most: the density of curved
// shapes that are sampled by area grows like an inverse root towards their rims.
TYPED_TEST(EachShapeAtRandom, DirectionsHaveTheirDensity) {
  constexpr int n = 400, samples = 120;
  double deviations = 0;
  int views = 0;
  for_each_placed<TypeParam>(12, 1, [&](const TypeParam& shape, const PlacedShape& placed, Pcg32& random) {
    const Vec3d middle = (placed.box.low + placed.box.high) * 0.5;
    const double reach = size_of(placed) / 2;
    for (const double away : {0.0, 1.3, 2.0, 10.0}) {
      if (away == 0 && TypeParam::flat) continue;
      const Vec3d axis = random_view(placed, TypeParam::flat, random), from = middle - axis * (reach * away);
      const double sine = away > 1 ? 1 / away : 1;
      const double opening = away > 1 ? sine * sine / (1 + std::sqrt(1 - sine * sine)) : 2;
      const Sum sum = sum_over_directions(placed, from, axis, opening, n, random);
      ASSERT_LT(sum.deviation(), 0.1) << "from " << away;
      deviations += sum.deviation(), ++views;
      ASSERT_NEAR(sum.total, 1, 4 * sum.deviation()) << "from " << away;
      Vec3d mean;
      for (int i = 0; i < samples; ++i)
        for (int k = 0; k < samples; ++k) {
          const auto toward =
              sample_toward(placed, from, (i + random.uniform()) / samples, (k + random.uniform()) / samples);
          ASSERT_TRUE(toward);
          ASSERT_NEAR(math::length(toward->direction), 1, 1e-14);
          ASSERT_EQ(toward->pdf, pdf_toward(placed, from, toward->direction, toward->distance));
          const Vec3r p = solve(placed.to_world, real(from + toward->direction * toward->distance));
          ASSERT_NEAR(Known<TypeParam>::carrier(shape, p), 0, 1e-9);
          mean = mean + toward->direction * (1.0 / (samples * samples));
        }
      ASSERT_NEAR(math::length(mean - sum.weighted), 0, 4 * sum.deviation()) << "from " << away;
    }
  });
  EXPECT_LT(deviations / views, 0.02);
}

TEST(Sphere, ConesAreExactHoweverTiny) {
  for (const auto& [radius, distance] :
       {std::pair{1e-9, 1.0}, std::pair{1.0, 1e9}, std::pair{1e-9, 1e9}, std::pair{1.0, 3.0}}) {
    const PlacedShape placed = place(SphereCap{}, placement({0, 0, -distance}, {}, {radius, radius, radius}));
    Pcg32 random(13);
    const Real ratio = static_cast<Real>(radius) / distance;
    const Real opening = ratio * ratio / (1 + std::sqrt(1 - ratio * ratio));
    double mean = 0;
    constexpr int n = 1000;
    for (int k = 0; k < n; ++k) {
      const auto toward = sample_toward(placed, {}, random.uniform(), random.uniform());
      ASSERT_TRUE(toward);
      ASSERT_NEAR(toward->pdf * 2 * std::numbers::pi * static_cast<double>(opening), 1, 1e-14);
      ASSERT_EQ(toward->pdf, pdf_toward(placed, {}, toward->direction, toward->distance));
      const double off = std::hypot(toward->direction.x, toward->direction.y) / static_cast<double>(ratio);
      ASSERT_LE(off, 1 + 1e-12);
      mean += off * off / n;
    }
    EXPECT_NEAR(mean, 0.5, 4 / std::sqrt(12.0 * n));  // uniform in the square of the sine, or nearly; four deviations
  }
}

// Of a rectangle all directions are equally likely, also from right before it, beside it, and nearly in its plane.
TEST(Quad, DirectionsAreUniform) {
  const PlacedShape placed = place(Quad{}, placement({0.3, -0.2, 0.1}, {25, -40, 70}, {2, 0.5, 1}));
  Pcg32 random(17);
  for (const Vec3d seen : {Vec3d{0, 0, 1}, {0, 0, -0.01}, {0.9, 0.9, 0.05}, {3, 0.2, 0.3}, {-2, 5, 1}, {1, 1, 1e-3}}) {
    const Vec3d from = apply_point(placed.to_world, seen);
    constexpr int n = 400;
    double inside = 0, pdf = 0;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const auto toward = sample_toward(placed, from, (i + random.uniform()) / n, (k + random.uniform()) / n);
        ASSERT_TRUE(toward);
        ASSERT_EQ(toward->pdf, pdf_toward(placed, from, toward->direction, toward->distance));
        ASSERT_TRUE(pdf == 0 || pdf == toward->pdf);
        pdf = toward->pdf;
        const Vec3d p = apply_point(placed.to_object, from + toward->direction * toward->distance);
        ASSERT_NEAR(p.z, 0, 1e-9);
        ASSERT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1 + 1e-9);
        inside += p.x < 0.25 && p.y < -0.5;
      }
    // A part of it, which is a rectangle again, gets its share.
    const PlacedShape part =
        place(Quad{}, compose(placed.to_world, placement({-0.375, -0.75, 0}, {}, {0.625, 0.25, 1})));
    const auto toward_part = sample_toward(part, from, 0.5, 0.5);
    ASSERT_TRUE(toward_part);
    EXPECT_NEAR(inside / (n * n), pdf / toward_part->pdf, 2e-3) << seen.x << " " << seen.y << " " << seen.z;
  }
}

TEST(Sphere, TheFarSideIsNeverChosen) {
  const PlacedShape placed = place(SphereCap{}, placement({0, 0, -4}, {}, {1, 1, 1}));
  const double near = pdf_toward(placed, {}, {0, 0, -1}, 3);
  EXPECT_NEAR(near, 1 / (2 * std::numbers::pi * (1 - std::sqrt(15.0) / 4)), 1e-13);
  EXPECT_EQ(pdf_toward(placed, {}, {0, 0, -1}, 5), 0);
}

TEST(Sphere, SampledUniformlyInSquares) {
  // Archimedes: equal bands of height and equal azimuths have equal areas. 8 x 8 cells.
  const PlacedShape placed = place(SphereCap{}, placement({}, {20, 30, 40}, {2, 2, 2}));
  Pcg32 random(14);
  constexpr int cells = 8, n = 64000;
  int count[cells][cells]{};
  for (int k = 0; k < n; ++k) {
    const Vec3d at = sample_area(placed, random.uniform(), random.uniform()).at.position;  // no turn of its own in this
    const int band = std::min(cells - 1, static_cast<int>((at.z / 2 + 1) / 2 * cells));
    const int sector =
        std::min(cells - 1, static_cast<int>((std::atan2(at.y, at.x) / (2 * std::numbers::pi) + 0.5) * cells));
    ++count[band][sector];
  }
  double chi = 0;
  constexpr double expected = n / (1.0 * cells * cells);
  for (const auto& row : count)
    for (const int c : row) chi += (c - expected) * (c - expected) / expected;
  EXPECT_LT(chi, 63 + 4 * std::sqrt(2 * 63.0));
  EXPECT_GT(chi, 63 - 4 * std::sqrt(2 * 63.0));
}

TEST(Area, ClosedForms) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(area(place(SphereCap{}, placement({1, 2, 3}, {10, 20, 30}, {3, 3, 3}))), 36 * pi, 1e-12);
  EXPECT_NEAR(area(place(SphereCap{0.25}, placement({}, {}, {3, -3, 3}))), 2 * pi * 9 * 0.75, 1e-12);
  EXPECT_NEAR(area(place(Quad{}, placement({}, {1, 2, 3}, {2, 3, 7}))), 24, 1e-12);
  EXPECT_NEAR(area(place(Disk{0.5}, placement({}, {1, 2, 3}, {2, 3, 7}))), 6 * pi * 0.75, 1e-12);
  EXPECT_NEAR(area(place(Triangle{}, triangle_placement({0, 0, 0}, {3, 0, 0}, {1, 4, 0}))), 6, 1e-13);
  // Of r = 1 + a P2(y): 4 pi (1 + a^2 (1/5 + 3/5)) to the second order, as the mean of P2^2 is 1/5 and of its slope
  // 6/5.
  EXPECT_NEAR(area(place(LobedSphere{1, {{2, 1e-3, {0, 1, 0}}}}, {})), 4 * pi * (1 + 0.8e-6), 1e-8);
  for (const double stretch : {1.5, 10.0, 100.0}) {
    const double e = std::sqrt(1 - 1 / (stretch * stretch));
    const double prolate = 2 * pi * (1 + stretch / e * std::asin(e));
    EXPECT_NEAR(area(place(SphereCap{}, placement({}, {5, 6, 7}, {1, stretch, 1}))), prolate, 1e-9 * prolate);
    EXPECT_NEAR(area(place(SphereCap{}, placement({}, {5, 6, 7}, {1, 1, stretch}))), prolate, 1e-9 * prolate);
    const double round = 4 * stretch * std::comp_ellint_2(e);  // the circumference of the ellipse
    EXPECT_NEAR(area(place(Cylinder{}, placement({}, {5, 6, 7}, {1, 4, stretch}))), 8 * round, 1e-9 * round);
  }
}

}  // namespace
}  // namespace shabon::geometry
