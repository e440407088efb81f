#include "shabon/geometry/sphere_set.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

namespace shabon::geometry {

struct SphereSet::Query {
  math::Vec3d origin, direction;
  int from = no_sphere;
  std::optional<std::span<const int>> holding = {};
  WallHit nearest{std::numeric_limits<double>::infinity(), no_sphere};

  // The nearest crossing in front of the origin, if it comes before what was found so far.
  void consider(const SphereShape& sphere, int index) {
    const auto distance = holding ? accounted_crossing(sphere, index) : first_crossing(sphere, index);
    if (!distance) return;
    const bool nearer = *distance < nearest.distance || (*distance == nearest.distance && index < nearest.sphere);
    if (nearer) nearest = {*distance, index};
  }

 private:
  std::optional<double> first_crossing(const SphereShape& sphere, int index) const {
    double distance;
    if (index == from) {
      distance = chord(origin, direction, sphere.center);
    } else {
      const auto roots = sphere_roots(origin, direction, sphere.center, sphere.radius);
      if (!(roots.half_chord_squared >= 0)) return {};
      const double half = std::sqrt(roots.half_chord_squared);
      distance = roots.middle - half > 0 ? roots.middle - half : roots.middle + half;
    }
    if (!(distance > 0)) return {};
    return distance;
  }

  std::optional<double> accounted_crossing(const SphereShape& sphere, int index) const {
    const bool held = std::binary_search(holding->begin(), holding->end(), index);
    if (index == from) {
      if (!held) return {};
      return std::max(0.0, chord(origin, direction, sphere.center));
    }
    const auto roots = sphere_roots(origin, direction, sphere.center, sphere.radius);
    if (!held && !(roots.half_chord_squared >= 0 && roots.middle > 0)) return {};
    const double half = std::sqrt(std::max(0.0, roots.half_chord_squared));
    return std::max(0.0, held ? roots.middle + half : roots.middle - half);
  }
};

namespace {

// Embree works in float. It sees the scene moved and scaled into the unit ball, and rays from where they enter it, so
// that neither size nor place of the scene costs digits; its boxes are larger than the spheres by more than float
// loses.
struct Frame {
  math::Vec3d center;
  double inverse_radius = 1;
};

// Rounding moves a ray by 6e-8 at its origin and 1.2e-7 at its end, and a box by 6e-8; Embree's own arithmetic doubles
// it.
constexpr double slack = 2e-6;

Frame frame_around(const std::vector<SphereShape>& spheres) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  math::Vec3d low{infinity, infinity, infinity}, high = -low;
  for (const SphereShape& s : spheres) {
    low = {std::min(low.x, s.center.x), std::min(low.y, s.center.y), std::min(low.z, s.center.z)};
    high = {std::max(high.x, s.center.x), std::max(high.y, s.center.y), std::max(high.z, s.center.z)};
  }
  const math::Vec3d center = low * 0.5 + high * 0.5;
  double radius = 0;
  for (const SphereShape& s : spheres) radius = std::max(radius, math::length(s.center - center) + s.radius);
  return {center, 1 / radius};
}

}  // namespace

struct SphereSet::Tree {
  // Embree hands the extended context back to the callback, which finds the double-precision ray behind it.
  struct Context {
    RTCIntersectContext base;
    Query* query;
    const SphereShape* spheres;
    double scale;  // from distances along the query's ray to those along Embree's,
    double start;  // which begins here
  };

  const SphereShape* spheres;
  Frame frame;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  explicit Tree(const std::vector<SphereShape>& all) : spheres(all.data()), frame(frame_around(all)) {
    // No number of threads: Embree would limit the whole process to it for as long as the device lives.
    device = rtcNewDevice("set_affinity=0");
    if (!device) return;
    scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(all.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
  }
  ~Tree() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const Tree& tree = *static_cast<const Tree*>(args->geometryUserPtr);
    const SphereShape& s = tree.spheres[args->primID];
    const math::Vec3d c = (s.center - tree.frame.center) * tree.frame.inverse_radius;
    const double reach = s.radius * tree.frame.inverse_radius + slack;
    RTCBounds& box = *args->bounds_o;
    box.lower_x = static_cast<float>(c.x - reach), box.upper_x = static_cast<float>(c.x + reach);
    box.lower_y = static_cast<float>(c.y - reach), box.upper_y = static_cast<float>(c.y + reach);
    box.lower_z = static_cast<float>(c.z - reach), box.upper_z = static_cast<float>(c.z + reach);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (!args->valid[0]) return;
    const auto* context = reinterpret_cast<const Context*>(args->context);
    context->query->consider(context->spheres[args->primID], static_cast<int>(args->primID));
    auto* ray = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const double far = std::max(0.0, context->query->nearest.distance * context->scale - context->start) + slack;
    ray->ray.tfar = std::min(ray->ray.tfar, static_cast<float>(far));
  }

  // Shows every sphere that the ray may meet first to consider().
  void search(Query& query) const {
    math::Vec3d origin = (query.origin - frame.center) * frame.inverse_radius;
    double start = 0;
    if (dot(origin, origin) > 1) {
      const auto ball = sphere_roots(origin, query.direction, math::Vec3d{}, 1 + slack);
      if (!(ball.half_chord_squared >= 0)) return;
      const double half = std::sqrt(ball.half_chord_squared);
      if (ball.middle + half < 0) return;
      start = std::max(0.0, ball.middle - half);
      origin = origin + query.direction * start;
    }
    Context context{{}, &query, spheres, frame.inverse_radius, start};
    rtcInitIntersectContext(&context.base);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x), ray.ray.org_y = static_cast<float>(origin.y);
    ray.ray.org_z = static_cast<float>(origin.z);
    ray.ray.dir_x = static_cast<float>(query.direction.x), ray.ray.dir_y = static_cast<float>(query.direction.y);
    ray.ray.dir_z = static_cast<float>(query.direction.z);
    ray.ray.tnear = 0, ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context.base, &ray);
  }
};

SphereSet::SphereSet(std::vector<SphereShape> spheres, WallSearch search) : spheres_(std::move(spheres)) {
  const bool is_few = spheres_.size() <= static_cast<std::size_t>(few);
  if (search == WallSearch::tree || (search == WallSearch::by_number && !is_few)) {
    tree_ = std::make_unique<Tree>(spheres_);
    if (!tree_->scene) tree_.reset();  // no Embree device: one by one is slower, and right
  }
}
SphereSet::~SphereSet() = default;
SphereSet::SphereSet(SphereSet&&) noexcept = default;
SphereSet& SphereSet::operator=(SphereSet&&) noexcept = default;

std::optional<WallHit> SphereSet::next_wall(math::Vec3d origin, math::Vec3d direction, int from) const {
  Query query{.origin = origin, .direction = direction, .from = from};
  return nearest_of(query);
}

std::optional<WallHit> SphereSet::next_wall(math::Vec3d origin, math::Vec3d direction, int from,
                                            std::span<const int> holding) const {
  Query query{.origin = origin, .direction = direction, .from = from, .holding = holding};
  return nearest_of(query);
}

std::optional<WallHit> SphereSet::nearest_of(Query& query) const {
  if (tree_)
    tree_->search(query);
  else
    for (std::size_t i = 0; i < spheres_.size(); ++i) query.consider(spheres_[i], static_cast<int>(i));
  if (query.nearest.sphere == no_sphere) return {};
  return query.nearest;
}

}  // namespace shabon::geometry
