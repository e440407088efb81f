// Black film: it grows at its speed, keeps the liquid, and the film breaks where it is asked to.
#include <numbers>

#include "laboratory.h"
#include "shabon/film/flow/exchange.h"

namespace shabon::film {
namespace {

using test::Laboratory;

FlowDesc thin_film() {
  FlowDesc desc = test::quiet_film();
  desc.radius_m = 0.03;
  desc.mean_thickness_nm = 52;
  desc.black_film = BlackFilmDesc{.spots_per_s = 0, .front_m_s = 0.02};
  return desc;
}

double black_area(const Laboratory& lab) {
  double area = 0;
  for (std::size_t c = 0; c < lab.film.thickness.size(); ++c)
    if (is_black(*lab.desc.black_film, lab.film.thickness[c])) area += lab.metric.area[c];
  return area;
}

TEST(BlackFilm, NeedsASpotToBegin) {
  Laboratory lab(thin_film());
  lab.run_to(0.5);
  EXPECT_EQ(black_area(lab), 0);
}

// The film outside thickens as it takes the liquid, until the rim holds the spot.
TEST(BlackFilm, GrowsFromASpotAndKeepsTheLiquid) {
  Laboratory lab(thin_film());
  lab.film.thickness[1234] = 30e-9;
  const double liquid = integral(lab.metric, lab.film.thickness);
  double before = black_area(lab);
  EXPECT_GT(before, 0);
  for (int n = 1; n <= 8; ++n) {
    lab.run_to(0.1 * n);
    const double now = black_area(lab);
    EXPECT_GE(now, before);
    before = now;
  }
  const double radius = std::sqrt(before / std::numbers::pi);
  std::printf("after 0.8 s: black spot of %.1f mm, front %.1f mm ahead at most\n", 1e3 * radius, 1e3 * 0.8 * 0.02);
  EXPECT_GT(radius, 2 * lab.metric.least_distance);
  EXPECT_LT(radius, 0.8 * 0.02 + 2 * lab.metric.least_distance);
  EXPECT_NEAR(integral(lab.metric, lab.film.thickness) / liquid, 1, 1e-12);
}

TEST(BlackFilm, IsSeededBySpots) {
  FlowDesc desc = thin_film();
  desc.black_film->spots_per_s = 1;
  Laboratory lab(desc);
  const double liquid = integral(lab.metric, lab.film.thickness);
  lab.run_to(0.5);
  EXPECT_GT(black_area(lab), 0);
  EXPECT_GT(lab.film.spots, 40);  // 113 cm^2, half a second
  EXPECT_LT(lab.film.spots, 60);
  EXPECT_NEAR(integral(lab.metric, lab.film.thickness) / liquid, 1, 1e-12);
}

TEST(Rupture, StopsTheFilmWhereItIsThinnest) {
  FlowDesc desc = test::quiet_film();
  desc.level = 3;
  desc.mean_thickness_nm = 100;
  desc.evaporation = EvaporationDesc{.rate_nm_s = 40, .top_excess = 0.5};
  desc.gravity_m_s2 = {0, -standard_gravity_m_s2, 0};
  desc.rupture = RuptureDesc{.from_nm = 40, .to_nm = 60};
  auto flow = FilmFlow::start(desc);
  ASSERT_TRUE(flow.ok());
  ASSERT_TRUE(flow->advance_to(100).ok());
  ASSERT_TRUE(flow->rupture().has_value());
  EXPECT_LT(flow->time_s(), 3);
  EXPECT_EQ(flow->rupture()->time_s, flow->time_s());
  EXPECT_GT(flow->rupture()->threshold_nm, 40);
  EXPECT_LT(flow->rupture()->threshold_nm, 60);
  EXPECT_NEAR(flow->report().thinnest_nm, flow->rupture()->threshold_nm, 1);
  EXPECT_GT(flow->rupture()->from_centre.y, 0.8);
  const double then = flow->time_s();
  auto resumed = FilmFlow::resume(flow->checkpoint());
  ASSERT_TRUE(resumed.ok());
  ASSERT_TRUE(resumed->advance_to(200).ok());
  EXPECT_EQ(resumed->time_s(), then);
}

}  // namespace
}  // namespace shabon::film
