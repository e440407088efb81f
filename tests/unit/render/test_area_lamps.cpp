// Points on lamps of every shape, with the sky among them: the light that they bring, and their densities.
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/render/sampling_checks.h"

namespace shabon::render {
namespace {

// Lamps of every shape, of which two shine on both sides, and one object that is no lamp.
scene::Scene lit_by_lamps(double sky_scale) {
  scene::Scene scene;
  scene.environment = with_base(scene::ConstantLight{0, sky_scale});
  scene.surfaces.push_back(scene::EmitterSurface{1, 5, false});
  scene.surfaces.push_back(scene::EmitterSurface{2, 2, true});
  scene.surfaces.push_back(scene::EmitterSurface{0, 0, true});
  const auto add = [&](const geometry::Shape& shape, const geometry::Affine& where, int surface) {
    scene.objects.push_back({geometry::place(shape, where), surface, 0});
  };
  using geometry::Affine;
  const auto at = [](Vec3d origin, Vec3d x, Vec3d y, Vec3d z) {
    Affine map;
    map.x = x;
    map.y = y;
    map.z = z;
    map.origin = origin;
    return map;
  };
  add(geometry::Quad{}, at({0, 3, 0}, {1, 0, 0}, {0, 0, 0.5}, {0, -1, 0}), 0);  // looks down
  add(geometry::SphereCap{}, at({-3, 1, 1}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}), 0);
  add(geometry::Disk{}, at({3, 2, -1}, {0, 0.7, 0}, {0, 0, 0.7}, {1, 0, 0}), 1);
  add(geometry::Cylinder{}, at({0, 1, -4}, {0.2, 0, 0}, {0, 1, 0}, {0, 0, 0.2}), 0);
  add(geometry::Torus{0.3}, at({-1, 3, 2}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}), 0);
  add(geometry::Triangle{}, at({1, 4, 3}, {1, 0, 0}, {0, 0.2, 1}, {0, 1, -0.2}), 1);
  add(geometry::Quad{}, at({0, -1, 0}, {9, 0, 0}, {0, 0, 9}, {0, -1, 0}), 2);
  add(geometry::LobedSphere{1, {{3, 0.2, {0, 1, 0}}}}, at({-2, 2, -3}, {0.4, 0, 0}, {0, 0.4, 0}, {0, 0, 0.4}), 0);
  return scene;
}

double emitted(const scene::Scene& scene, std::size_t object, const geometry::SurfacePoint& at, const Vec3d& away) {
  const auto& surface =
      std::get<scene::EmitterSurface>(scene.surfaces[static_cast<std::size_t>(scene.objects[object].surface)]);
  return surface.both_sides || math::dot(at.normal, away) < 0 ? surface.scale : 0;
}

// Light on a receiver: by an even grid over each lamp's area.
double irradiance(const scene::Scene& scene, const Vec3d& point, const Vec3d& normal) {
  double sum = 0;
  constexpr int steps = 150;
  for (std::size_t object = 0; object < scene.objects.size(); ++object)
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const auto found = geometry::sample_area(scene.objects[object].shape, (i + 0.5) / steps, (j + 0.5) / steps);
        const Vec3d to_it = found.at.position - point;
        const double distance = math::length(to_it);
        const Vec3d d = to_it * (1 / distance);
        const double light = emitted(scene, object, found.at, d) * std::max(0.0, math::dot(d, normal));
        sum +=
            light * std::abs(math::dot(found.at.normal, d)) / (distance * distance) / found.pdf_area / (steps * steps);
      }
  return sum;
}

TEST(AreaLamps, ShapesOfLampsCoverTheList) {
  std::set<std::size_t> shapes;
  for (const scene::Object& object : lit_by_lamps(0).objects) shapes.insert(object.shape.shape.index());
  EXPECT_EQ(shapes.size(), std::variant_size_v<geometry::Shape>);
}

TEST(AreaLamps, MeansOverLampsAreTheirLightWithTheSky) {
  for (const double sky_scale : {0.0, 0.3}) {
    const scene::Scene scene = lit_by_lamps(sky_scale);
    const LampSampling lamps(scene);
    ASSERT_TRUE(lamps.has_lamps());
    for (const Vec3d& point : {Vec3d{0, 0, 0}, {-2, 0.2, 1}, {1.3, 3.2, -0.7}, {30, 20, 10}})
      for (const Vec3d& normal : normals) {
        SCOPED_TRACE(testing::Message() << sky_scale << " at " << point.x << ", normal " << normal.y);
        const double expected = irradiance(scene, point, normal) + pi * sky_scale;
        Mean mean;
        Chance chance;
        for (int i = 0; i < 40'000; ++i) {
          const auto found = lamps.sample(point, chance(), chance(), chance());
          if (!found) {
            mean.add(0);
            continue;
          }
          const double cosine = std::max(0.0, math::dot(found->direction, normal));
          if (found->object < 0) {
            ASSERT_EQ(found->pdf, lamps.pdf_infinity(point, found->direction));
            mean.add(sky_scale * cosine / found->pdf);
            continue;
          }
          ASSERT_EQ(found->pdf, lamps.pdf_object(point, found->object, found->direction, found->distance));
          const auto object = static_cast<std::size_t>(found->object);
          const auto at = geometry::surface_at(scene.objects[object].shape, point, found->direction, found->distance);
          mean.add(emitted(scene, object, at, found->direction) * cosine / found->pdf);
        }
        EXPECT_NEAR(mean.value(), expected, errors_allowed * mean.error() + 2e-3 * expected);
      }
  }
}

TEST(AreaLamps, OnlyLampsHaveADensity) {
  const scene::Scene scene = lit_by_lamps(0.3);
  const LampSampling lamps(scene);
  EXPECT_EQ(lamps.pdf_object({0, 0, 0}, 6, {0, -1, 0}, 1), 0);  // the one of scale 0
  EXPECT_GT(lamps.pdf_object({0, 0, 0}, 0, {0, 1, 0}, 3), 0);
  // Densities of all lamps and of the sky add up to one choice.
  double share = 0;
  Chance chance;
  constexpr int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const auto found = lamps.sample({0, 0, 0}, (i + 0.5) / count, chance(), chance());
    share += found && found->object < 0;
  }
  const double sky = over_all_directions(200, 100, [&](const Vec3d& d) { return lamps.pdf_infinity({0, 0, 0}, d); });
  EXPECT_NEAR(share / count, sky, 1e-2);
}

}  // namespace
}  // namespace shabon::render
