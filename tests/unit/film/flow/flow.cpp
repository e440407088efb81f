// The film as its users see it: same bits alone, beside others, and after a restart; messages; damaged checkpoints.
#include "shabon/film/flow/flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "shabon/film/flow/bake.h"
#include "shabon/film/flow/listing.h"
#include "shabon/film/flow/presets.h"
#include "shabon/film/latitude_map.h"
#include "shabon/film/sphere_map.h"

namespace shabon::film {
namespace {

using math::Vec3d;

// Everything that a film can have.
FlowDesc busy_film(std::uint64_t seed) {
  FlowDesc desc;
  desc.level = 3;
  desc.seed = seed;
  desc.mean_thickness_nm = 160;
  desc.initial = {.equilibrium = true, .noise = 0.3, .swirl_m_s = 0.2};
  desc.air = {AirGusts{.rate_per_s = 8, .speed_m_s = 1.6}, AirSwirls{}, AirRotation{}, AirJet{}};
  desc.evaporation = EvaporationDesc{};
  desc.regeneration = RegenerationDesc{};
  desc.black_film = BlackFilmDesc{.nucleation_nm = 130};
  desc.rupture = RuptureDesc{.from_nm = 1, .to_nm = 2};
  return desc;
}

FilmFlow started(const FlowDesc& desc) {
  auto flow = FilmFlow::start(desc);
  EXPECT_TRUE(flow.ok()) << to_text(flow.errors());
  return std::move(*flow);
}

std::vector<std::byte> run(std::uint64_t seed) {
  FilmFlow flow = started(busy_film(seed));
  for (int frame = 1; frame <= 8; ++frame) EXPECT_TRUE(flow.advance_to(0.05 * frame).ok());
  return flow.checkpoint();
}

TEST(FilmFlow, GivesTheSameBitsAloneAndBesideAnother) {
  const auto one = run(1), two = run(2);
  EXPECT_NE(one, two);
  std::vector<std::byte> beside_one, beside_two;
  std::thread first([&] { beside_one = run(1); }), second([&] { beside_two = run(2); });
  first.join(), second.join();
  EXPECT_EQ(beside_one, one);
  EXPECT_EQ(beside_two, two);
}

TEST(FilmFlow, GoesOnWithTheSameBitsAfterARestart) {
  FilmFlow straight = started(busy_film(3));
  std::vector<std::byte> half;
  for (int frame = 1; frame <= 20; ++frame) {
    ASSERT_TRUE(straight.advance_to(0.05 * frame).ok());
    if (frame == 10) half = straight.checkpoint();
  }
  EXPECT_GT(straight.report().steps, 150);
  EXPECT_GT(straight.report().drop_m3, 0);
  EXPECT_GT(straight.report().black_share, 0);
  auto resumed = FilmFlow::resume(half);
  ASSERT_TRUE(resumed.ok()) << to_text(resumed.errors());
  EXPECT_EQ(resumed->checkpoint(), half);
  EXPECT_EQ(resumed->time_s(), 0.5);
  for (int frame = 11; frame <= 20; ++frame) ASSERT_TRUE(resumed->advance_to(0.05 * frame).ok());
  EXPECT_EQ(resumed->checkpoint(), straight.checkpoint());
}

TEST(Checkpoint, IsRefusedWhenDamaged) {
  const auto whole = run(1);
  ASSERT_TRUE(FilmFlow::resume(whole).ok());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{5}, std::size_t{40}, whole.size() / 2, whole.size() - 1}) {
    const auto cut = FilmFlow::resume(std::span(whole).first(length));
    ASSERT_FALSE(cut.ok()) << length;
    EXPECT_EQ(cut.errors().front().failure, Failure::content);
  }
  for (std::size_t at = 0; at < whole.size(); at += 997) {
    auto changed = whole;
    changed[at] ^= std::byte{1};
    EXPECT_FALSE(FilmFlow::resume(changed).ok()) << at;
  }
  auto longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(FilmFlow::resume(longer).ok());
}

TEST(FilmFlow, TellsEveryProblemOfADescription) {
  FlowDesc desc;
  desc.radius_m = -1;
  desc.mean_thickness_nm = std::nan("");
  desc.level = 9;
  desc.air = {AirRotation{}, AirJet{.direction = {0, 0, 0}, .envelope = {.ramp_s = -1}}};
  desc.black_film = BlackFilmDesc{.thickness_nm = 40, .nucleation_nm = 30};
  desc.step.courant = 2;
  const auto flow = FilmFlow::start(desc);
  ASSERT_FALSE(flow.ok());
  std::vector<std::string> keys;
  for (const Diagnostic& problem : flow.errors()) {
    keys.push_back(problem.key);
    EXPECT_FALSE(problem.message.empty());
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"level", "radius_m", "mean_thickness_nm", "air[1].jet.envelope.ramp_s",
                                            "air[1].jet.direction", "black_film.thickness_nm", "step.courant"}));
}

TEST(FilmFlow, StopsWithItsLastGoodStateAndSaysWhatToChange) {
  FlowDesc desc;
  desc.level = 3;
  desc.air = {AirRotation{.speed_m_s = 20, .envelope = {.ramp_s = 0}}};
  desc.step.longest_s = desc.step.shortest_s = 1e-3;
  FilmFlow flow = started(desc);
  const Status stopped = flow.advance_to(10);
  ASSERT_FALSE(stopped.ok());
  EXPECT_NE(to_text(stopped.errors()).find("slow down what drives it"), std::string::npos) << to_text(stopped.errors());
  EXPECT_LT(flow.time_s(), 10);
  for (const double h : flow.thickness_m()) EXPECT_TRUE(h > 0 && h < 1e-5);
}

// Shorter steps help a solver that hardly converges, but not one that cannot: then the film stops at once.
TEST(FilmFlow, StopsAtOnceWhenTheSolverFails) {
  FlowDesc desc;
  desc.level = 3;
  desc.step.most_iterations = 1;
  desc.step.tolerance = 1e-12;
  FilmFlow flow = started(desc);
  const Status unsolved = flow.advance_to(1);
  ASSERT_FALSE(unsolved.ok());
  for (const char* part : {"step.most_iterations", "step.tolerance", "in steps of 0.0005 s"})
    EXPECT_NE(to_text(unsolved.errors()).find(part), std::string::npos) << to_text(unsolved.errors());
  EXPECT_EQ(flow.time_s(), 0);
  EXPECT_EQ(flow.report().repeated, 5);
}

// Whatever differs between two films is told by its key.
TEST(FlowListing, NamesEveryValue) {
  const auto differing = [](const FlowDesc& a, const FlowDesc& b) {
    std::vector<std::string> keys;
    const auto x = listed(a), y = listed(b);
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
      if (x[i] != y[i]) keys.push_back(x[i].first);
    return keys;
  };
  const FlowDesc one = busy_film(1);
  EXPECT_TRUE(differing(one, busy_film(1)).empty());
  EXPECT_EQ(differing(one, busy_film(2)), (std::vector<std::string>{"seed"}));
  FlowDesc other = one;
  other.radius_m = std::nextafter(one.radius_m, 1.0);
  other.gravity_m_s2.x = 1;
  other.initial.equilibrium = !one.initial.equilibrium;
  std::get<AirGusts>(other.air[0]).speed_m_s += 1e-9;
  other.evaporation->top_excess = 0.1;
  other.step.most_iterations++;
  EXPECT_EQ(differing(one, other),
            (std::vector<std::string>{"radius_m", "gravity_m_s2", "initial.equilibrium", "air[0].gusts.speed_m_s",
                                      "evaporation.top_excess", "step.most_iterations"}));
}

// Three bounds above and below the default; the storm makes every one of them count.
TEST(FilmFlow, KeepsToTheBoundOfCrossedCells) {
  for (const double bound : {0.1, 0.3, 0.72}) {
    FlowDesc desc;
    desc.level = 3;
    desc.initial.swirl_m_s = 0.2;
    desc.air = {AirRotation{.speed_m_s = 5, .envelope = {.ramp_s = 0.01}}};
    desc.step.courant = bound;
    FilmFlow flow = started(desc);
    ASSERT_TRUE(flow.advance_to(0.1).ok());
    EXPECT_GT(flow.report().courant, bound / 1.25);
    EXPECT_LE(flow.report().courant, bound);
  }
}

// A film at rest that a storm takes along: the first steps turn out too long and are taken back.
TEST(FilmFlow, NeverCrossesMoreCellsThanItMay) {
  FlowDesc desc;
  desc.level = 3;
  desc.mean_thickness_nm = 200;
  desc.gravity_m_s2 = {0, 0, 0};
  desc.air = {AirRotation{.speed_m_s = 10, .envelope = {.ramp_s = 0}}};
  FilmFlow flow = started(desc);
  ASSERT_TRUE(flow.advance_to(0.05).ok());
  EXPECT_GT(flow.report().repeated, 0);
  EXPECT_GT(flow.report().courant, 0.3);
  EXPECT_LE(flow.report().courant, desc.step.courant);
}

// The most viscous film on the smallest bubble: its shear dies away within microseconds.
TEST(FilmFlow, StaysSlowWhereShearIsStiff) {
  const auto fastest_m_s = [](double longest_s) {
    FlowDesc desc;
    desc.level = 3, desc.radius_m = 0.005, desc.mean_thickness_nm = 50, desc.surface_viscosity_kg_s = 1e-6;
    desc.step.longest_s = longest_s;
    auto flow = FilmFlow::start(desc);
    EXPECT_TRUE(flow->advance_to(0.1).ok());
    return flow->report().fastest_m_s;
  };
  const double fine = fastest_m_s(1e-5);
  EXPECT_NEAR(fastest_m_s(8e-3), fine, 0.1 * fine);
  EXPECT_LT(fine, 5e-3);  // what drag alone would allow
}

TEST(FilmFlow, StopsWhenAsked) {
  FilmFlow flow = started(busy_film(1));
  const StopFlag stop{true};
  EXPECT_TRUE(flow.advance_to(1, &stop).ok());
  EXPECT_EQ(flow.time_s(), 0);
}

TEST(FilmFlow, StartsFromAGivenThickness) {
  FlowDesc desc;
  desc.level = 3;
  desc.initial.noise = 0;
  const auto flow = FilmFlow::start(desc, [](const Vec3d& at) { return 500 + 100 * at.y; });
  ASSERT_TRUE(flow.ok());
  for (std::size_t c = 0; c < flow->directions().size(); ++c)
    EXPECT_NEAR(flow->thickness_m()[c] * 1e9, 800 * (1 + 0.2 * flow->directions()[c].y), 0.1);
  EXPECT_FALSE(FilmFlow::start(desc, [](const Vec3d& at) { return at.y; }).ok());
}

// Straight in height whatever way gravity points, with its mean, and with the surfactant of (95) under it.
TEST(FilmFlow, StartsStraightInHeight) {
  for (const Vec3d& down : {Vec3d{0, -1, 0}, Vec3d{1, 2, -2} * (1.0 / 3)}) {
    FlowDesc desc;
    desc.level = 4;
    desc.mean_thickness_nm = 525;
    desc.elasticity_n_m = 1e-3;
    desc.gravity_m_s2 = down * 9.0;
    desc.initial = {.equilibrium = true, .slope = 5.0 / 7, .noise = 0};
    const FilmFlow flow = started(desc);
    const double a = 1000 * 9.0 * 0.03 * 525e-9 / 1e-3;
    double mean = 0, area = 0;
    for (std::size_t c = 0; c < flow.directions().size(); ++c) {
      const double depth = dot(down, flow.directions()[c]);
      EXPECT_NEAR(flow.thickness_m()[c] * 1e9, 525 + 375 * depth, 0.05);
      EXPECT_NEAR(flow.surfactant()[c], 1 + a * (depth + 5.0 / 14 * (depth * depth - 1.0 / 3)), 1e-4);
      mean += flow.areas_m2()[c] * flow.thickness_m()[c];
      area += flow.areas_m2()[c];
    }
    EXPECT_NEAR(mean / area * 1e9, 525, 1e-9);
    desc.initial.equilibrium = false;
    const FilmFlow falling = started(desc);
    for (const double surfactant : falling.surfactant()) EXPECT_NEAR(surfactant, 1, 1e-12);
    EXPECT_EQ(falling.thickness_m()[7], flow.thickness_m()[7]);
  }
}

// A film so heavy that no surfactant would be left at its top, and one that no gravity tells up from down.
TEST(FilmFlow, RefusesAStraightFilmThatCannotBe) {
  FlowDesc desc;
  desc.radius_m = 0.1;
  desc.initial = {.equilibrium = true, .slope = 0.6, .noise = 0};
  const double most = 1 / (1 - 0.6 / 3);
  const auto problem_at = [&](double a) {
    desc.elasticity_n_m = desc.density_kg_m3 * length(desc.gravity_m_s2) * desc.radius_m * 800e-9 / a;
    return check(desc);
  };
  EXPECT_TRUE(problem_at(0.999 * most).empty());
  ASSERT_EQ(problem_at(1.001 * most).size(), 1u);
  EXPECT_EQ(problem_at(1.001 * most)[0].key, "initial.equilibrium");
  desc.initial.equilibrium = false;
  EXPECT_TRUE(problem_at(1.001 * most).empty());
  desc.gravity_m_s2 = {0, 0, 0};
  ASSERT_EQ(check(desc).size(), 1u);
  EXPECT_EQ(check(desc)[0].key, "initial.slope");
}

// The same film at another level: noise, eddies and events do not follow the cells.
TEST(FilmFlow, StartsAlikeAtEveryLevel) {
  FlowDesc desc;
  desc.seed = 9;
  desc.initial = {.noise = 0.3, .noise_scale_m = 0.02, .swirl_m_s = 0.1};
  std::vector<Vec3d> places;
  for (int i = 0; i < 200; ++i) {
    const double z = -0.99 + 0.0099 * i, turn = 2.4 * i;
    places.push_back({std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z});
  }
  std::vector<float> coarse(places.size()), fine(places.size());
  desc.level = 4;
  const FilmFlow one = started(desc);
  FlowBake(one, places).thickness_nm(one, coarse);
  desc.level = 5;
  const FilmFlow two = started(desc);
  FlowBake(two, places).thickness_nm(two, fine);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(coarse[i] / fine[i], 1, 0.05);
  EXPECT_GT(*std::max_element(fine.begin(), fine.end()), 1.3 * *std::min_element(fine.begin(), fine.end()));
}

TEST(FlowBake, IsLinearBetweenCells) {
  FlowDesc desc;
  desc.level = 5;
  desc.initial.noise = 0;
  const auto flow = FilmFlow::start(desc, [](const Vec3d& at) { return 500 + 100 * at.x - 50 * at.z; });
  ASSERT_TRUE(flow.ok());
  std::vector<Vec3d> places(flow->directions().begin(), flow->directions().end());
  const std::size_t cells = places.size();
  for (const auto& [a, b, c] : flow->triangles()) {
    const auto at = [&](int cell) { return flow->directions()[static_cast<std::size_t>(cell)]; };
    places.push_back(at(a) * 0.5 + at(b) * 0.3 + at(c) * 0.2);
  }
  std::vector<float> nm(places.size());
  FlowBake(*flow, places).thickness_nm(*flow, nm);
  for (std::size_t i = 0; i < cells; ++i) EXPECT_NEAR(nm[i], flow->thickness_m()[i] * 1e9, 1e-3);
  for (std::size_t i = cells; i < places.size(); ++i)
    EXPECT_NEAR(nm[i], 800 * (1 + 0.2 * places[i].x - 0.1 * places[i].z), 0.02);
}

// The picture of a thickness, looked up as the renderer does, is that thickness.
TEST(FlowBake, FillsTheRenderersPictures) {
  FlowDesc desc;
  desc.level = 5;
  desc.initial.noise = 0;
  const auto nm_at = [](const Vec3d& at) { return 800 * (1 + 0.2 * at.x - 0.1 * at.y + 0.3 * at.z); };
  const auto flow = FilmFlow::start(desc, nm_at);
  ASSERT_TRUE(flow.ok());
  constexpr int width = 256, height = 128;
  auto raster = std::make_shared<math::Raster>();
  raster->width = width, raster->height = height, raster->channels = 1;
  raster->values.resize(width * height);
  FlowBake(*flow, latitude_longitude_directions(width, height)).thickness_nm(*flow, raster->values);
  SphereMap cube;
  cube.size = 65;
  const auto nodes = node_directions(cube.size);
  cube.nm.resize(nodes.size());
  FlowBake(*flow, nodes).thickness_nm(*flow, cube.nm);
  const LatitudeMap latitude{raster};
  for (int i = 0; i < 500; ++i) {
    const double z = -0.95 + 0.0038 * i, turn = 2.4 * i;
    const Vec3d at{std::sqrt(1 - z * z) * std::cos(turn), z, std::sqrt(1 - z * z) * std::sin(turn)};
    EXPECT_NEAR(thickness_nm(latitude, at), nm_at(at), 0.5);
    EXPECT_NEAR(thickness_nm(cube, at), nm_at(at), 0.5);
  }
}

TEST(FlowPresets, AreValidAndRun) {
  std::vector<std::string_view> names;
  for (const FlowPreset& preset : flow_presets()) {
    EXPECT_EQ(std::count(names.begin(), names.end(), preset.name), 0) << preset.name;
    names.push_back(preset.name);
    EXPECT_EQ(flow_preset(preset.name), &preset);
    EXPECT_TRUE(preset.doc.ends_with('.')) << preset.name;
    FlowDesc desc = preset.desc;
    desc.level = 3;
    FilmFlow flow = started(desc);
    const Status done = flow.advance_to(0.5);
    EXPECT_TRUE(done.ok()) << preset.name << to_text(done.errors());
    EXPECT_GT(flow.report().fastest_m_s, 0.001) << preset.name;
  }
  EXPECT_GE(names.size(), 8u);
  EXPECT_EQ(flow_preset("no such film"), nullptr);
}

TEST(FlowPresets, Linear1989BeginsAsThePictureOfThePaper) {
  const FilmFlow flow = started(flow_preset("linear1989")->desc);
  for (std::size_t c = 0; c < flow.directions().size(); ++c)
    EXPECT_NEAR(flow.thickness_m()[c] * 1e9, 525 - 375 * flow.directions()[c].y, 0.02);
}

}  // namespace
}  // namespace shabon::film
