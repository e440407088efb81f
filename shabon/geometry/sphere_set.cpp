#include "shabon/geometry/sphere_set.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

namespace shabon::geometry {

namespace {

struct Query {
  math::Vec3d origin, direction;
  int from = no_sphere;
  WallHit nearest{std::numeric_limits<double>::infinity(), no_sphere};
};

// The nearest crossing in front of the origin, if it comes before what was found so far.
void consider(Query& query, const SphereShape& sphere, int index) {
  double distance;
  if (index == query.from) {
    distance = chord(query.origin, query.direction, sphere.center);
  } else {
    const auto roots = sphere_roots(query.origin, query.direction, sphere.center, sphere.radius);
    if (!(roots.half_chord_squared >= 0)) return;
    const double half = std::sqrt(roots.half_chord_squared);
    distance = roots.middle - half > 0 ? roots.middle - half : roots.middle + half;
  }
  if (!(distance > 0)) return;
  const bool nearer = distance < query.nearest.distance ||
                      (distance == query.nearest.distance && index < query.nearest.sphere);
  if (nearer) query.nearest = {distance, index};
}

// Embree hands the extended context back to the callback, which finds the double-precision ray behind it.
struct Context {
  RTCIntersectContext base;
  Query* query;
  const SphereShape* spheres;
};

// Rounded away from the sphere by more than float can lose, so that no candidate is missed.
void bounds(const RTCBoundsFunctionArguments* args) {
  const auto* spheres = static_cast<const SphereShape*>(args->geometryUserPtr);
  const SphereShape& s = spheres[args->primID];
  const auto reach = [&](double c) { return s.radius + 1e-5 * (s.radius + std::abs(c)); };
  RTCBounds& box = *args->bounds_o;
  box.lower_x = static_cast<float>(s.center.x - reach(s.center.x));
  box.lower_y = static_cast<float>(s.center.y - reach(s.center.y));
  box.lower_z = static_cast<float>(s.center.z - reach(s.center.z));
  box.upper_x = static_cast<float>(s.center.x + reach(s.center.x));
  box.upper_y = static_cast<float>(s.center.y + reach(s.center.y));
  box.upper_z = static_cast<float>(s.center.z + reach(s.center.z));
}

void intersect(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  auto* context = reinterpret_cast<Context*>(args->context);
  consider(*context->query, context->spheres[args->primID], static_cast<int>(args->primID));
  // Embree culls boxes beyond tfar; a margin keeps walls that float cannot tell from the nearest one.
  auto* ray = reinterpret_cast<RTCRayHit*>(args->rayhit);
  const double far = context->query->nearest.distance * (1 + 1e-5) + 1e-5;
  ray->ray.tfar = std::min(ray->ray.tfar, static_cast<float>(far));
}

}  // namespace

struct SphereSet::Tree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  explicit Tree(const std::vector<SphereShape>& spheres) {
    device = rtcNewDevice("threads=1,set_affinity=0");
    if (!device) return;
    scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.size()));
    rtcSetGeometryUserData(geometry, const_cast<SphereShape*>(spheres.data()));
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
};

SphereSet::SphereSet(std::vector<SphereShape> spheres) : spheres_(std::move(spheres)) {
  if (!has_few()) tree_ = std::make_unique<Tree>(spheres_);
}
SphereSet::~SphereSet() = default;
SphereSet::SphereSet(SphereSet&&) noexcept = default;
SphereSet& SphereSet::operator=(SphereSet&&) noexcept = default;

std::optional<WallHit> SphereSet::next_wall(math::Vec3d origin, math::Vec3d direction, int from) const {
  Query query{origin, direction, from};
  if (!tree_ || !tree_->scene) {
    for (std::size_t i = 0; i < spheres_.size(); ++i) consider(query, spheres_[i], static_cast<int>(i));
  } else {
    Context context;
    rtcInitIntersectContext(&context.base);
    context.query = &query;
    context.spheres = spheres_.data();
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x), ray.ray.org_y = static_cast<float>(origin.y);
    ray.ray.org_z = static_cast<float>(origin.z);
    ray.ray.dir_x = static_cast<float>(direction.x), ray.ray.dir_y = static_cast<float>(direction.y);
    ray.ray.dir_z = static_cast<float>(direction.z);
    ray.ray.tnear = 0, ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(tree_->scene, &context.base, &ray);
  }
  if (query.nearest.sphere == no_sphere) return {};
  return query.nearest;
}

}  // namespace shabon::geometry
