// Every lobe of every surface: its directions come as often as its density says, light takes the same way in both
// directions, and no more light leaves than arrives.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/render/kernel/scattering/lobe.h"
#include "tests/statistical/surface_cases.h"

namespace shabon {
namespace {

using render::FramedRow;
using render::Lanes;
using render::Lobe;
using render::Lobes;
using render::LocalFrame;
using render::Vertex;
using testing_surfaces::SurfaceCase;

constexpr double pi = std::numbers::pi;
const math::Vec3d up{0, 0, 1};

class LobesOf : public ::testing::TestWithParam<SurfaceCase> {
 protected:
  LobesOf() : scene_(testing_surfaces::lit_from_everywhere(1, 1, 1)) {
    const int surface = GetParam().add(scene_);
    testing_surfaces::add_object(scene_, geometry::Quad{}, geometry::placement({0, 0, 0}), surface);
    tables_.emplace(scene_);
  }

  // A ray that arrives in the xz plane at this angle, from the front or the back.
  Vertex arrival(double angle_deg, bool from_back) const {
    const double a = angle_deg * pi / 180;
    return arrival_along({std::sin(a), 0, from_back ? std::cos(a) : -std::cos(a)});
  }

  Vertex arrival_along(const math::Vec3d& direction) const {
    Vertex vertex;
    vertex.at.normal = up;
    vertex.direction = direction;
    vertex.from_back = direction.z > 0;
    vertex.normal = vertex.from_back ? -up : up;
    vertex.cos_o = std::abs(direction.z);
    vertex.hero = 7;
    vertex.one_lane = true;
    return vertex;
  }

  Lobes lobes(const Vertex& vertex) const {
    Lobes result;
    render::lobes_of(*tables_, vertex, 0, -1, result);
    return result;
  }

  scene::Scene scene_;
  std::optional<render::ScatteringTables> tables_;
};

FramedRow unpolarized_row() { return {render::unpolarized(Lanes(1.0f)), {}, false}; }

// Cells of equal solid angle over the sphere of directions.
constexpr int rows = 24, columns = 24;
int cell_of(const math::Vec3d& d) {
  const int row = std::min(rows - 1, static_cast<int>((1 - d.z) / 2 * rows));
  const double turn = 0.5 + std::atan2(d.y, d.x) / (2 * pi);
  return row * columns + std::min(columns - 1, static_cast<int>(turn * columns));
}

TEST_P(LobesOf, DirectionsComeAsOftenAsTheirDensitySays) {
  Pcg32 random(1);
  for (const bool from_back : {false, true})
    for (const double angle_deg : {0.0, 40.0, 80.0}) {
      const Vertex vertex = arrival(angle_deg, from_back);
      const LocalFrame frame(vertex.normal);
      const Lobes found = lobes(vertex);
      for (int k = 0; k < found.count; ++k) {
        const Lobe& lobe = found.lobe[k];
        if (render::is_smooth(lobe.kind)) continue;
        constexpr int count = 150000, steps = 900, turns = 240;
        std::vector<double> seen(rows * columns), expected(rows * columns);
        for (int i = 0; i < count; ++i) {
          math::Vec3d direction;
          if (render::sample(vertex, frame, lobe, random.uniform(), random.uniform(), random.uniform(), direction))
            seen[static_cast<std::size_t>(cell_of(direction))] += 1.0 / count;
        }
        for (int i = 0; i < steps; ++i)
          for (int j = 0; j < turns; ++j) {
            const double polar = pi * (i + 0.5) / steps, across = std::sin(polar);
            const double turn = 2 * pi * ((j + 0.5) / turns - 0.5);
            const math::Vec3d direction{across * std::cos(turn), across * std::sin(turn), std::cos(polar)};
            expected[static_cast<std::size_t>(cell_of(direction))] +=
                render::density(vertex, frame, lobe, direction) * 2 * pi * pi / (steps * turns) * across;
          }
        double distance = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) distance += std::abs(seen[i] - expected[i]) / 2;
        // A fair die with so many faces is off by about sqrt(faces/(2 pi count)) = 0.025.
        EXPECT_LT(distance, 0.032) << angle_deg << (from_back ? " from the back" : "") << ", lobe " << k << ", kind "
                                   << int(lobe.kind);
      }
    }
}

TEST_P(LobesOf, LightTakesTheSameWayBack) {
  Pcg32 random(2);
  int compared = 0;
  // Of one direction, in the medium it runs through: n^2 times the cosine.
  const auto& coating = tables_->surfaces.back().coating;
  const double n_squared_behind = coating && !coating->opaque ? double(coating->n_behind_squared[0][7]) : 1;
  const auto etendue = [&](const math::Vec3d& d) { return std::abs(d.z) * (d.z > 0 ? 1 : n_squared_behind); };
  for (int i = 0; i < 4000; ++i) {
    const auto any = [&] {
      const double z = random.uniform(-1, 1), turn = random.uniform(0, 2 * pi), across = std::sqrt(1 - z * z);
      return math::Vec3d{across * std::cos(turn), across * std::sin(turn), z};
    };
    const math::Vec3d away = any(), towards = any();
    if (std::min(std::abs(away.z), std::abs(towards.z)) < 0.05) continue;
    // f(away -> towards) |cos| against f back: all non-smooth lobes together.
    const auto value = [&](const math::Vec3d& arriving, const math::Vec3d& leaving) {
      const Vertex vertex = arrival_along(arriving);
      const LocalFrame frame(vertex.normal);
      const Lobes found = lobes(vertex);
      double sum = 0;
      for (int k = 0; k < found.count; ++k)
        if (!render::is_smooth(found.lobe[k].kind))
          sum += double(render::scattered(vertex, frame, found.lobe[k], unpolarized_row(), leaving).row.q0[7]) *
                 double(found.lobe[k].share);
      return sum;
    };
    const double there = value(away, towards) / etendue(towards), back = value(-towards, -away) / etendue(-away);
    if (there < 1e-12 && back < 1e-12) continue;
    ++compared;
    EXPECT_NEAR(there, back, 2e-3 * std::max(there, back) + 1e-6) << away.z << " " << towards.z;
  }
  bool scatters = false;
  const Lobes found = lobes(arrival(30, false));
  for (int k = 0; k < found.count; ++k) scatters = scatters || !render::is_smooth(found.lobe[k].kind);
  if (scatters) {
    EXPECT_GT(compared, 100);
  }
}

// What goes on of unpolarised light along one lobe, by points that fill the space of chances evenly.
double power_of(const Vertex& vertex, const LocalFrame& frame, const Lobe& lobe) {
  if (render::is_smooth(lobe.kind)) return double(lobe.block.a[7]) * double(lobe.share);
  constexpr int count = 12000;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const auto chance = [i](double step) { return std::fmod(0.5 + i * step, 1.0); };
    math::Vec3d direction;
    // Powers of the root of x^4 = x + 1 (the generalised golden ratio).
    if (!render::sample(vertex, frame, lobe, chance(0.8191725133961645), chance(0.6710436067037893),
                        chance(0.5497004779019703), direction))
      continue;
    const double density = render::density(vertex, frame, lobe, direction);
    if (density > 0)
      sum += double(render::scattered(vertex, frame, lobe, unpolarized_row(), direction).row.q0[7]) *
             double(lobe.share) / density;
  }
  return sum / count;
}

TEST_P(LobesOf, KeepWhatArrives) {
  for (const bool from_back : {false, true})
    for (const double angle_deg : {0.0, 30.0, 60.0, 80.0, 89.0}) {
      const Vertex vertex = arrival(angle_deg, from_back);
      const LocalFrame frame(vertex.normal);
      const Lobes found = lobes(vertex);
      double sum = found.emits ? 1 : 0;
      for (int k = 0; k < found.count; ++k) sum += power_of(vertex, frame, found.lobe[k]);
      // The tables of rough boundaries are good to 3e-3, dispersive ones to 5e-3, and this sum to 1e-3.
      EXPECT_LT(sum, 1.007) << angle_deg << (from_back ? " from the back" : "");
      if (GetParam().keeps_light) {
        EXPECT_GT(sum, 1 - GetParam().may_lose - 0.007) << angle_deg << (from_back ? " from the back" : "");
      }
    }
}

INSTANTIATE_TEST_SUITE_P(All, LobesOf, ::testing::ValuesIn(testing_surfaces::surface_cases()),
                         [](const auto& tested) { return testing_surfaces::test_name(tested.param); });

}  // namespace
}  // namespace shabon
