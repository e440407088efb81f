// What is kept over many steps: liquid, surfactant, bounds, positive thickness; ledgers that add up.
#include <numbers>

#include "laboratory.h"

namespace shabon::film {
namespace {

using test::Laboratory;

FlowDesc in_gusts() {
  FlowDesc desc;
  desc.level = test::level - 1;
  desc.radius_m = 0.05;
  desc.mean_thickness_nm = 1000;
  AirGusts gusts;
  gusts.speed_m_s = 1.6;
  gusts.rate_per_s = 4;
  desc.air = {gusts, AirSwirls{}, AirRotation{}};
  return desc;
}

TEST(Conservation, HoldsOverTenThousandStepsInGusts) {
  FlowDesc desc = in_gusts();
  desc.step.longest_s = 2e-3;
  Laboratory lab(desc);
  const double liquid = integral(lab.metric, lab.film.thickness),
               surfactant = integral(lab.metric, lab.film.surfactant);
  const auto bounds = [&] {
    double least = 1, most = 0;
    for (std::size_t c = 0; c < lab.film.thickness.size(); ++c) {
      const double ratio = lab.film.thickness[c] / lab.film.surfactant[c];
      least = std::min(least, ratio), most = std::max(most, ratio);
    }
    return std::pair(least, most);
  };
  const auto [least, most] = bounds();
  double liquid_drift = 0, surfactant_drift = 0, fastest = 0;
  while (lab.film.frame.steps < 10'000) {
    lab.run_to(lab.film.time_s + 0.25);
    liquid_drift = std::max(liquid_drift, std::abs(integral(lab.metric, lab.film.thickness) / liquid - 1));
    surfactant_drift = std::max(surfactant_drift, std::abs(integral(lab.metric, lab.film.surfactant) / surfactant - 1));
    const auto [low, high] = bounds();
    ASSERT_GE(low, least * (1 - 1e-12));
    ASSERT_LE(high, most * (1 + 1e-12));
    for (const double u : lab.film.along.values()) fastest = std::max(fastest, std::abs(u));
  }
  std::printf("level %d, %d steps to %.1f s, up to %.2f m/s: liquid %.1e, surfactant %.1e\n", desc.level,
              lab.film.frame.steps, lab.film.time_s, fastest, liquid_drift, surfactant_drift);
  EXPECT_GT(fastest, 0.2);
  EXPECT_LT(liquid_drift, 1e-12);
  EXPECT_LT(surfactant_drift, 1e-12);
}

TEST(Conservation, UniformRatioStaysUniformInTheWholeStep) {
  FlowDesc desc = in_gusts();
  desc.initial.noise = 0;
  Laboratory lab(desc);
  lab.run_to(1);
  double least = 1, most = 0, thinnest = 1, thickest = 0;
  for (std::size_t c = 0; c < lab.film.thickness.size(); ++c) {
    const double ratio = lab.film.thickness[c] / lab.film.surfactant[c];
    least = std::min(least, ratio), most = std::max(most, ratio);
    thinnest = std::min(thinnest, lab.film.thickness[c]), thickest = std::max(thickest, lab.film.thickness[c]);
  }
  EXPECT_GT(thickest / thinnest, 1.01);
  EXPECT_LT(most / least - 1, 1e-12);
}

TEST(Evaporation, TakesWhatItSays) {
  FlowDesc desc = in_gusts();
  desc.gravity_m_s2 = {0, 0, 0};
  desc.evaporation = EvaporationDesc{.rate_nm_s = 100};
  Laboratory lab(desc);
  const double before = integral(lab.metric, lab.film.thickness);
  lab.run_to(2);
  const double after = integral(lab.metric, lab.film.thickness), r = desc.radius_m;
  const double expected = before - 4 * std::numbers::pi * r * r * 100e-9 * 2;
  EXPECT_NEAR(after / expected, 1, 1e-10);
  EXPECT_NEAR((after + lab.film.evaporated_m3) / before, 1, 1e-12);
}

TEST(Ledgers, AddUpWithEverySource) {
  FlowDesc desc = in_gusts();
  desc.mean_thickness_nm = 150;
  desc.evaporation = EvaporationDesc{.rate_nm_s = 30, .top_excess = 0.5};
  desc.regeneration = RegenerationDesc{};
  desc.black_film = BlackFilmDesc{.nucleation_nm = 100};
  Laboratory lab(desc);
  const double liquid = integral(lab.metric, lab.film.thickness),
               surfactant = integral(lab.metric, lab.film.surfactant);
  lab.run_to(3);
  const double film = integral(lab.metric, lab.film.thickness);
  double black = 0;
  for (const double h : lab.film.thickness.values()) {
    EXPECT_GT(h, 0);
    black += h < 40e-9;
  }
  EXPECT_GT(lab.film.drop_m3, 0.001 * liquid);
  EXPECT_GT(lab.film.evaporated_m3, 0.1 * liquid);
  EXPECT_GT(black, 3);
  EXPECT_NEAR((film + lab.film.drop_m3 + lab.film.evaporated_m3) / liquid, 1, 1e-12);
  EXPECT_NEAR(integral(lab.metric, lab.film.surfactant) / surfactant, 1, 1e-12);
}

}  // namespace
}  // namespace shabon::film
