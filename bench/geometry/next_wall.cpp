#include "bench/geometry/next_wall.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/geometry/block_search.h"
#include "bench/micro.h"
#include "bench/scenes.h"
#include "shabon/base/random.h"

namespace shabon::bench {

namespace {

using geometry::SphereSet;
using geometry::SphereShape;
using geometry::WallSearch;
using math::Vec3d;

constexpr double seconds_each = 0.02;

// As many bubbles as asked for, of random sizes, spread through one volume: they overlap now and then.
std::vector<SphereShape> random_spheres(int count) {
  std::vector<SphereShape> spheres;
  const double size = std::cbrt(1.0 / count);
  const auto random = [](int i, std::uint64_t stream) {
    return unit_double(hash64(stream, static_cast<std::uint64_t>(i)));
  };
  for (int i = 0; i < count; ++i) {
    const Vec3d center{random(i, 1) * 2 - 1, random(i, 2) * 2 - 1, random(i, 3) * 2 - 1};
    spheres.push_back({center * (1 - size), size * (0.4 + 0.6 * random(i, 4))});
  }
  return spheres;
}

// What the renderer asks: rays of a camera and, from every wall they meet, the reflected and the transmitted ray.
WallRays rays_among(const SphereSet& spheres) {
  constexpr int columns = 24, rows = 24;
  constexpr int most_depth = 4;
  struct Ray {
    Vec3d origin, direction;
    int from, depth;
  };
  std::vector<Ray> open;
  const Vec3d eye{0, 0, 4};
  for (int i = 0; i < columns * rows; ++i) {
    const Vec3d target{(i % columns + 0.5) * 2.4 / columns - 1.2, (i / columns + 0.5) * 2.4 / rows - 1.2, 0};
    open.push_back({eye, math::normalize(target - eye), geometry::no_sphere, 0});
  }
  WallRays rays;
  while (!open.empty()) {
    const Ray ray = open.back();
    open.pop_back();
    rays.origin.push_back(ray.origin), rays.direction.push_back(ray.direction), rays.from.push_back(ray.from);
    const auto hit = spheres.next_wall(ray.origin, ray.direction, ray.from);
    if (!hit || ray.depth == most_depth) continue;
    const SphereShape& sphere = spheres.spheres()[static_cast<std::size_t>(hit->sphere)];
    const Vec3d point = ray.origin + ray.direction * hit->distance;
    const Vec3d normal = (point - sphere.center) * (1 / sphere.radius);
    const Vec3d mirrored = ray.direction - normal * (2 * math::dot(ray.direction, normal));
    open.push_back({point, math::normalize(mirrored), hit->sphere, ray.depth + 1});
    open.push_back({point, ray.direction, hit->sphere, ray.depth + 1});
  }
  return rays;
}

double search_all(const SphereSet& spheres, const WallRays& rays) {
  double sum = 0;
  for (std::size_t i = 0; i < rays.from.size(); ++i)
    if (const auto hit = spheres.next_wall(rays.origin[i], rays.direction[i], rays.from[i])) sum += hit->distance;
  return sum;
}

// One number of spheres, searched in every way.
struct Case {
  int count;
  SphereSet one_by_one, tree;
  WallRays rays;
  BlockSearch blocks;
  Case(int number, const scene::Scene& scene)
      : count(number),
        one_by_one(random_spheres(number), WallSearch::one_by_one),
        tree(random_spheres(number), WallSearch::tree),
        rays(rays_among(one_by_one)),
        blocks(scene, random_spheres(number), rays) {}

  std::vector<Micro> loops() {
    const auto items = static_cast<double>(rays.from.size());
    return {{fmt::format("{} spheres, blocks of 8 rays", count), [this] { return blocks.run(); }, items},
            {fmt::format("{} spheres, one by one", count), [this] { return search_all(one_by_one, rays); }, items},
            {fmt::format("{} spheres, tree", count), [this] { return search_all(tree, rays); }, items}};
  }
};

Status check(const std::vector<Micro>& loops) {
  constexpr double most_difference = 1e-9;  // relative; fused a*b+c rounds differently
  const double expected = loops.back().run();
  for (const Micro& loop : loops) {
    const double got = loop.run();
    if (!(std::abs(got - expected) <= most_difference * expected))
      return fail(Failure::internal, fmt::format("{}: expected the distance {}, got {}", loop.name, expected, got));
  }
  return Done{};
}

}  // namespace

Status bench_next_wall(Report& report, int repetitions) {
  const auto scene = plain_bubble("1.333", "airy");
  if (!scene) return scene.errors();
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<Micro> loops;
  for (const int count : {1, 2, 4, 8, 16, 32, 64, 1000}) {
    cases.push_back(std::make_unique<Case>(count, *scene));
    const auto more = cases.back()->loops();
    if (const Status same = check(more); !same) return same;
    loops.insert(loops.end(), more.begin(), more.end());
  }
  const auto times = nanoseconds_per_item(loops, repetitions, seconds_each);
  for (std::size_t i = 0; i < loops.size(); ++i) report.record("geometry", loops[i].name, "ns per ray", times[i]);

  report.heading("The next wall");
  report.paragraph(fmt::format(
      "Nanoseconds per ray to find the next wall among random spheres, for camera rays and four levels of their\n"
      "branches: one by one in blocks of 8 rays (the renderer, up to {} spheres), one by one for a single ray "
      "(`probe`),\n"
      "and by Embree's tree.",
      SphereSet::few));
  Table table({"spheres", "blocks of 8 rays", "one by one", "tree", "tree over blocks", "tree over one by one"});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Spread* t = &times[3 * i];
    table.add({std::to_string(cases[i]->count), shown(t[0], 1), shown(t[1], 1), shown(t[2], 1),
               fmt::format("{:.2f}", t[2].median / t[0].median), fmt::format("{:.2f}", t[2].median / t[1].median)});
  }
  report.table(table);
  return Done{};
}

}  // namespace shabon::bench
