// Rays that meet the bubbles of a scene: at all angles, and many close to grazing.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "oracle.h"
#include "shabon/base/random.h"
#include "shabon/render/probe.h"

namespace shabon::testing_scenes {

inline math::Vec3d random_direction(Pcg32& random) {
  const double z = random.uniform(-1, 1), azimuth = random.uniform(0, 2 * std::numbers::pi);
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

// Aimed at a point of one bubble's disk as seen from somewhere outside, every third one within 1 % of its rim; every
// fifth one starts near the centre of the scene, within the bubbles.
inline std::vector<oracle::Ray> rays_at(const scene::SceneDesc& scene, int count, std::uint64_t seed) {
  Pcg32 random(seed);
  std::vector<oracle::Ray> rays;
  for (int i = 0; i < count; ++i) {
    const auto& object = scene.objects[random() % scene.objects.size()];
    const auto& bubble = std::get<scene::BubbleDesc>(object);
    const math::Vec3d d = random_direction(random);
    const math::Vec3d side = math::normalize(math::cross(d, random_direction(random)));
    const double reach = i % 3 == 2 ? 1 - std::pow(10.0, random.uniform(-6, -2)) : std::sqrt(random.uniform());
    math::Vec3d origin = bubble.center + side * (bubble.radius * reach);
    if (i % 5 != 4) origin = origin - d * 5.0;
    rays.push_back({origin, d, false});
  }
  return rays;
}

// Through random points of the picture, by the camera's definition: full vertical angle, square pixels.
inline std::vector<oracle::Ray> camera_rays(const scene::SceneDesc& scene, int count, std::uint64_t seed) {
  Pcg32 random(seed);
  std::vector<oracle::Ray> rays;
  const auto& camera = scene.camera;
  const math::Vec3d ahead = math::normalize(camera.target() - camera.position);
  const math::Vec3d right = math::normalize(math::cross(ahead, camera.up)), up = math::cross(right, ahead);
  const double half_height = std::tan(camera.vertical_fov_deg.value_or(scene::default_vertical_fov_deg) * std::numbers::pi / 360);
  const double half_width = half_height * scene.image.width / scene.image.height;
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform(-1, 1), v = random.uniform(-1, 1);
    rays.push_back({camera.position, ahead + right * (u * half_width) + up * (v * half_height), true});
  }
  return rays;
}

// Those whose trees are small enough for a slow oracle: films that face each other near grazing incidence hand light to
// and fro between them for millions of events.
inline std::vector<oracle::Ray> with_small_trees(const scene::Scene& scene, const std::vector<oracle::Ray>& rays,
                                                 std::uint64_t most_events) {
  std::vector<oracle::Ray> result;
  const double nm[] = {550};
  for (const oracle::Ray& ray : rays) {
    const auto probed = render::probe(scene, {ray.origin, ray.direction, ray.through_polarizer}, nm);
    if (probed && probed->film_events <= most_events) result.push_back(ray);
  }
  return result;
}

}  // namespace shabon::testing_scenes
