// Gravity against elasticity: the film comes to rest where (79) says, whatever way gravity points.
#include "laboratory.h"

namespace shabon::film {
namespace {

using math::Vec3d;
using test::Laboratory;

// Relative error over the sphere after the film has come to rest.
double error_at_rest(int level, double a, const Vec3d& down) {
  FlowDesc desc = test::quiet_film();
  desc.level = level;
  desc.viscosity_pa_s = 1e-2;
  desc.air_drag_kg_m2_s = 0.04;
  desc.step.tolerance = 1e-10;
  desc.gravity_m_s2 = math::normalize(down) * standard_gravity_m_s2;
  desc.elasticity_n_m = desc.density_kg_m3 * standard_gravity_m_s2 * desc.radius_m * desc.mean_thickness_nm * 1e-9 / a;
  Laboratory lab(desc);
  lab.run_to(4);
  double difference = 0, norm = 0, fastest = 0;
  for (std::size_t c = 0; c < lab.film.thickness.size(); ++c) {
    const double height = -math::dot(math::normalize(down), lab.metric.grid->centres[c]);
    const double exact = 1e-6 * a / std::sinh(a) * std::exp(-a * height), off = lab.film.thickness[c] - exact;
    difference += lab.metric.area[c] * off * off;
    norm += lab.metric.area[c] * exact * exact;
  }
  for (const double u : lab.film.along.values()) fastest = std::max(fastest, std::abs(u));
  EXPECT_LT(fastest, 2e-4);
  return std::sqrt(difference / norm);
}

TEST(Equilibrium, IsReachedWithSecondOrder) {
  for (const double a : {0.1, 0.5, 1.0}) {
    const double coarse = error_at_rest(test::level - 1, a, {0, -1, 0}),
                 fine = error_at_rest(test::level, a, {0, -1, 0});
    std::printf("a %.1f: L2 %.2e at level %d, %.2e at level %d, order %.2f\n", a, coarse, test::level - 1, fine,
                test::level, std::log2(coarse / fine));
    EXPECT_GT(std::log2(coarse / fine), 1.8) << a;
    EXPECT_LT(fine, a == 1 ? 5e-4 : 2e-4) << a;
  }
}

// How far a film straight in height goes in two seconds with nothing but gravity: L2, relative to its mean.
double drift_of_straight_film(double a, bool balanced) {
  FlowDesc desc = test::quiet_film();
  desc.viscosity_pa_s = 1e-2;
  desc.air_drag_kg_m2_s = 0.04;
  desc.step.tolerance = 1e-10;
  desc.gravity_m_s2 = {0, -standard_gravity_m_s2, 0};
  desc.elasticity_n_m = desc.density_kg_m3 * standard_gravity_m_s2 * desc.radius_m * desc.mean_thickness_nm * 1e-9 / a;
  desc.initial.slope = 5.0 / 7;
  desc.initial.equilibrium = balanced;
  Laboratory lab(desc);
  const Numbers start = lab.film.thickness;
  lab.run_to(2);
  double sum = 0, area = 0;
  for (std::size_t c = 0; c < start.size(); ++c) {
    const double off = (lab.film.thickness[c] - start[c]) / (desc.mean_thickness_nm * 1e-9);
    sum += lab.metric.area[c] * off * off;
    area += lab.metric.area[c];
  }
  return std::sqrt(sum / area);
}

// To what the solver leaves, not only to the order of the grid: the difference of (95) between two cells is that of
// their depths times the mean of their thicknesses.
TEST(Equilibrium, HoldsAStraightFilmStill) {
  for (const double a : {0.1, 0.8}) {
    const double still = drift_of_straight_film(a, true), falls = drift_of_straight_film(a, false);
    std::printf("a %.1f: a straight film goes %.1e of its thickness in 2 s, unbalanced %.1e\n", a, still, falls);
    EXPECT_LT(still, 1e-9) << a;
    EXPECT_GT(falls, 1e-3) << a;
  }
}

TEST(Equilibrium, HasNoImprintOfTheGrid) {
  const int level = test::level - 1;
  const auto grid = sphere_grid(level);
  std::vector<Vec3d> ways = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 1, 1}, {-1, 2, 0.5}};
  for (Index c = 0; c < grid->topology.cells && ways.size() < 8; ++c)  // and along pentagons
    if (grid->topology.around(c).sign[0] == 0) ways.push_back(grid->centres[static_cast<std::size_t>(c)]);
  ASSERT_EQ(ways.size(), 8u);
  double least = 1, most = 0;
  for (const Vec3d& way : ways) {
    const double error = error_at_rest(level, 0.5, way);
    least = std::min(least, error), most = std::max(most, error);
  }
  std::printf("largest over least error of 8 ways of gravity: %.4f\n", most / least);
  EXPECT_LT(most / least, 1.05);
}

}  // namespace
}  // namespace shabon::film
