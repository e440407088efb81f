#include "bench/geometry/next_shape.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "bench/micro.h"
#include "shabon/base/random.h"
#include "shabon/geometry/shape_set.h"

namespace shabon::bench {

namespace {

using geometry::PlacedShape;
using geometry::Shape;
using geometry::ShapeSearch;
using geometry::ShapeSet;
using math::Vec3d;

constexpr double seconds_each = 0.02;

template <std::size_t... I>
Shape of_kind(std::size_t kind, std::index_sequence<I...>) {
  Shape shape;
  ((kind == I ? void(shape.emplace<I>()) : void()), ...);
  return shape;
}

// As many shapes as asked for, of all kinds in turn, turned at random and spread through one volume.
std::vector<PlacedShape> random_shapes(int count) {
  constexpr std::size_t kinds = std::variant_size_v<Shape>;
  Pcg32 random(1);
  std::vector<PlacedShape> shapes;
  const double spacing = std::cbrt(1.0 / count);
  for (int i = 0; i < count; ++i) {
    const auto any = [&](double most) {
      return Vec3d{random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
    };
    const double size = spacing * random.uniform(0.4, 1);
    const auto map = geometry::placement(any(1 - spacing), any(180), {size, size, size});
    shapes.push_back(
        geometry::place(of_kind(static_cast<std::size_t>(i) % kinds, std::make_index_sequence<kinds>()), map));
  }
  return shapes;
}

struct Ray {
  Vec3d origin, direction;
  int from = geometry::no_shape;
  int depth = 0;
  double limit = std::numeric_limits<double>::infinity();
};

// What a renderer asks: rays of a camera and, from every shape they meet, the reflected ray, the transmitted one, and
// one to a lamp that is not farther than the lamp.
std::vector<Ray> rays_among(const ShapeSet& set) {
  constexpr int columns = 24, rows = 24;
  constexpr int most_depth = 4;
  const Vec3d eye{0, 0, 4}, lamp{1, 3, 2};
  std::vector<Ray> open, rays;
  for (int i = 0; i < columns * rows; ++i) {
    const Vec3d target{(i % columns + 0.5) * 2.4 / columns - 1.2, (i / columns + 0.5) * 2.4 / rows - 1.2, 0};
    open.push_back({eye, math::normalize(target - eye)});
  }
  while (!open.empty()) {
    const Ray ray = open.back();
    open.pop_back();
    rays.push_back(ray);
    const auto hit = set.next(ray.origin, ray.direction, ray.from);
    if (!hit || ray.depth == most_depth) continue;
    const auto& shape = set.shapes()[static_cast<std::size_t>(hit->shape)];
    const auto at = geometry::surface_at(shape, ray.origin, ray.direction, hit->distance);
    const Vec3d mirrored = ray.direction - at.normal * (2 * math::dot(ray.direction, at.normal));
    open.push_back({at.position, math::normalize(mirrored), hit->shape, ray.depth + 1});
    open.push_back({at.position, ray.direction, hit->shape, ray.depth + 1});
    const Vec3d to_lamp = lamp - at.position;
    rays.push_back({at.position, math::normalize(to_lamp), hit->shape, 0, math::length(to_lamp)});
  }
  return rays;
}

double search_all(const ShapeSet& set, const std::vector<Ray>& rays) {
  double sum = 0;
  for (const Ray& ray : rays)
    if (const auto hit = set.next(ray.origin, ray.direction, ray.from, ray.limit)) sum += hit->distance;
  return sum;
}

// One number of shapes, searched in both ways.
struct Case {
  int count;
  ShapeSet one_by_one, tree;
  std::vector<Ray> rays;
  explicit Case(int number)
      : count(number),
        one_by_one(random_shapes(number), ShapeSearch::one_by_one),
        tree(random_shapes(number), ShapeSearch::tree),
        rays(rays_among(one_by_one)) {}

  std::vector<Micro> loops() const {
    const auto items = static_cast<double>(rays.size());
    return {{fmt::format("{} shapes, one by one", count), [this] { return search_all(one_by_one, rays); }, items},
            {fmt::format("{} shapes, tree", count), [this] { return search_all(tree, rays); }, items}};
  }
};

}  // namespace

Status bench_next_shape(Report& report, int repetitions) {
  std::vector<std::unique_ptr<Case>> cases;
  std::vector<Micro> loops;
  for (const int count : {1, 2, 4, 8, 12, 16, 24, 32, 64, 1000}) {
    cases.push_back(std::make_unique<Case>(count));
    const auto both = cases.back()->loops();
    if (const double expected = both[0].run(), got = both[1].run(); got != expected)
      return fail(Failure::internal, fmt::format("{}: expected the distance {}, got {}", both[1].name, expected, got));
    loops.insert(loops.end(), both.begin(), both.end());
  }
  const auto times = nanoseconds_per_item(loops, repetitions, seconds_each);
  for (std::size_t i = 0; i < loops.size(); ++i) report.record("geometry", loops[i].name, "ns per ray", times[i]);

  report.heading("The next shape");
  report.paragraph(
      fmt::format("Nanoseconds per ray to find the next of shapes of all kinds, for camera rays, four levels of their "
                  "branches, and\n"
                  "rays to a lamp: one by one (up to {} shapes), and by Embree's tree.",
                  ShapeSet::few));
  Table table({"shapes", "one by one", "tree", "tree over one by one"});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Spread* t = &times[2 * i];
    table.add({std::to_string(cases[i]->count), shown(t[0], 1), shown(t[1], 1),
               fmt::format("{:.2f}", t[1].median / t[0].median)});
  }
  report.table(table);
  return Done{};
}

}  // namespace shabon::bench
