// Rays at the edge of what geometry allows: through centres, along tangents, from walls, through points where walls
// touch or cross. Everything stays finite, and every wall is met.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle.h"
#include "scenes.h"
#include "shabon/render/probe.h"
#include "shabon/render/render.h"

namespace shabon {
namespace {

const render::RenderOptions one_thread = [] {
  render::RenderOptions options;
  options.threads = 1;
  return options;
}();

const std::vector<double> wavelengths = {400, 550, 700};
constexpr optics::Interference models[] = {optics::Interference::airy, optics::Interference::two_beam,
                                           optics::Interference::none};

scene::SceneDesc scene_in(const std::string& arrangement, const std::string& light, optics::Interference model) {
  scene::SceneDesc scene = scene_of(testing_scenes::arrangement(arrangement), testing_scenes::light(light));
  scene.render.interference = model;
  scene.camera.polarizer_deg = 25;
  return scene;
}

// Origins and directions in all combinations: centres, walls, the outside; axes, diagonals and what touches a wall.
std::vector<render::ProbeRay> edge_rays(const scene::SceneDesc& scene) {
  std::vector<render::ProbeRay> rays;
  const math::Vec3d directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},    {0, 0, 1},      {0, 0, -1},
                                    {1, 1, 0}, {1, 1, 1},  {-3, 0, 4}, {1e-9, 0, -1}, {0, 1e-160, -1}};
  for (const auto& object : scene.objects) {
    const auto& bubble = std::get<scene::BubbleDesc>(object);
    for (const math::Vec3d& d : directions) {
      const math::Vec3d unit = math::normalize(d);
      for (const double distance : {0.0, -1.0, 1.0, -5.0})  // the centre, both walls, far in front
        rays.push_back({bubble.center + unit * (distance * bubble.radius), d, true});
      const math::Vec3d side =
          math::normalize(math::cross(unit, std::abs(unit.x) < 0.5 ? math::Vec3d{1, 0, 0} : math::Vec3d{0, 1, 0}));
      rays.push_back({bubble.center + side * bubble.radius, d, true});               // from the point that it touches
      rays.push_back({bubble.center + side * bubble.radius - unit * 4.0, d, true});  // towards it
    }
  }
  return rays;
}

TEST(EdgeRays, stay_finite) {
  for (const std::string name : {"single", "no thickness", "dense", "overlapping", "touching", "air in water"}) {
    for (const auto model : models) {
      const scene::SceneDesc description = scene_in(name, "windows", model);
      const scene::Scene scene = testing_scenes::compiled(description);
      for (const render::ProbeRay& ray : edge_rays(description)) {
        const auto result = render::probe(scene, ray, wavelengths);
        ASSERT_TRUE(result.ok());
        for (const double value : result->radiance) {
          ASSERT_TRUE(std::isfinite(value)) << name << ", " << optics::name_of(model) << ", direction "
                                            << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z;
          ASSERT_GE(value, 0) << name << ", " << optics::name_of(model);
        }
      }
    }
  }
}

// The picture's axis goes exactly through the centre of the bubble, or the camera stands on its wall or inside.
TEST(EdgeRays, of_pictures_stay_finite) {
  for (const auto& arrangement : testing_scenes::arrangements()) {
    if (arrangement.name == "coincident" || arrangement.name == "concentric") continue;  // large trees, nothing new
    for (const auto model : models) {
      if (!testing_scenes::computable(arrangement, model)) continue;
      scene::SceneDesc description = scene_in(arrangement.name, "windows", model);
      const auto& bubble = std::get<scene::BubbleDesc>(description.objects[0]);
      for (const double distance : {0.0, 1.0, 1e-9, 5.0}) {
        description.camera.position = bubble.center + math::Vec3d{0, 0, distance * bubble.radius};
        description.camera.look_at = description.camera.position - math::Vec3d{0, 0, 1};
        description.camera.vertical_fov_deg = distance == 5 ? 1e-6 : 160;
        description.image = {4, 4};
        description.render.samples = 4;
        const scene::Scene scene = testing_scenes::compiled(description);
        render::Sensor sensor(scene.width, scene.height);
        const auto report = render::render(scene, one_thread, sensor);
        ASSERT_TRUE(report.ok());
        EXPECT_EQ(report->dropped_samples, 0u)
            << arrangement.name << ", " << optics::name_of(model) << ", " << distance;
        for (int y = 0; y < scene.height; ++y)
          for (int x = 0; x < scene.width; ++x) {
            const color::Xyz mean = sensor.mean(x, y);
            ASSERT_TRUE(std::isfinite(mean.x) && std::isfinite(mean.y) && std::isfinite(mean.z))
                << arrangement.name << ", " << optics::name_of(model) << ", " << distance;
          }
      }
    }
  }
}

struct SharedPoint {
  std::string name;
  std::vector<scene::ObjectDesc> bubbles;
  math::Vec3d origin, direction;
};

scene::ObjectDesc even(math::Vec3d center, double radius, double thickness_nm) {
  return testing_scenes::bubble(center, radius, "1.5", film::ConstantThickness{thickness_nm});
}

// Walls that share a point, with coordinates that are exact in binary, and rays through it.
std::vector<SharedPoint> shared_points() {
  const auto outside = std::vector{even({-1, 0, 0}, 1, 300), even({1, 0, 0}, 1, 420)};
  const auto inside = std::vector{even({-1, 0, 0}, 1, 300), even({-0.5, 0, 0}, 0.5, 420)};
  const auto crossing = std::vector{even({-3, 0, 0}, 5, 300), even({3, 0, 0}, 5, 420)};  // both hold (0, 4, 0)
  const auto three = std::vector{even({-1, 0, 0}, 1, 300), even({1, 0, 0}, 1, 420), even({-0.5, 0, 0}, 0.5, 200)};
  const auto reversed = [](std::vector<scene::ObjectDesc> bubbles) {
    std::reverse(bubbles.begin(), bubbles.end());
    return bubbles;
  };
  std::vector<SharedPoint> list;
  const auto add = [&](const std::string& name, const std::vector<scene::ObjectDesc>& bubbles, math::Vec3d point,
                       math::Vec3d d) {
    list.push_back({name, bubbles, point - d * 8.0, d});
    list.push_back({name + ", reversed", reversed(bubbles), point - d * 8.0, d});
  };
  for (const math::Vec3d d : {math::Vec3d{1, 0, 0}, {-1, 0, 0}, {1, 1, 0}, {-1, 0.5, 0.25}, {3, 0, 4}}) {
    add("touching outside", outside, {}, d);
    add("touching inside", inside, {}, d);
    add("three", three, {}, d);
  }
  // Where walls cross, their order decides where light goes; along these rays it is exact, and the first object's.
  for (const math::Vec3d d : {math::Vec3d{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}}) add("crossing", crossing, {0, 4, 0}, d);
  return list;
}

// The lamps differ in every direction, so that a wall that is missed is seen.
TEST(EdgeRays, meet_all_walls_that_share_a_point) {
  for (const SharedPoint& at : shared_points()) {
    scene::SceneDesc description = testing_scenes::scene_of({at.name, at.bubbles}, testing_scenes::light("softboxes"));
    const auto expected = oracle::arriving(description, {at.origin, at.direction, false}, wavelengths);
    const auto got =
        render::probe(testing_scenes::compiled(description), {at.origin, at.direction, false}, wavelengths);
    ASSERT_TRUE(got.ok());
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
      EXPECT_NEAR(got->radiance[i], expected.radiance[i], 2e-5 * expected.radiance[i])
          << at.name << ", direction " << at.direction.x << ' ' << at.direction.y << ' ' << at.direction.z << ", "
          << got->film_events << " events, expected " << expected.events;
  }
}

}  // namespace
}  // namespace shabon
