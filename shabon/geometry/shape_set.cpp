#include "shabon/geometry/shape_set.h"

#include <embree3/rtcore.h>

#include <algorithm>

#include "shabon/geometry/sphere.h"

namespace shabon::geometry {

struct ShapeSet::Query {
  math::Vec3d origin, direction;
  int from = no_shape;
  ShapeHit nearest{std::numeric_limits<double>::infinity(), no_shape};

  void consider(const PlacedShape& shape, int index) {
    const auto distance = next_crossing(shape, origin, direction, index == from);
    if (!distance) return;
    const bool nearer = *distance < nearest.distance || (*distance == nearest.distance && index < nearest.shape);
    if (nearer) nearest = {*distance, index};
  }
};

namespace {

using math::Vec3d;

// Embree works in float. As in sphere_set.cpp it sees the scene moved and scaled into the unit ball, and rays from
// where they enter it, so that neither size nor place of the scene costs digits; its boxes are larger than the shapes
// by more than float loses.
struct Frame {
  Vec3d center;
  double inverse_radius = 1;
};

// Rounding moves a ray by 6e-8 at its origin and 1.2e-7 at its end, and a box by 6e-8; Embree's own arithmetic doubles
// it.
constexpr double slack = 2e-6;

Frame frame_around(const std::vector<PlacedShape>& shapes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3d low{infinity, infinity, infinity}, high = -low;
  for (const PlacedShape& s : shapes) {
    low = {std::min(low.x, s.box.low.x), std::min(low.y, s.box.low.y), std::min(low.z, s.box.low.z)};
    high = {std::max(high.x, s.box.high.x), std::max(high.y, s.box.high.y), std::max(high.z, s.box.high.z)};
  }
  if (shapes.empty()) return {};
  return {low * 0.5 + high * 0.5, 1 / math::length(high * 0.5 - low * 0.5)};
}

}  // namespace

struct ShapeSet::Tree {
  // Embree hands the extended context back to the callback, which finds the double-precision ray behind it.
  struct Context {
    RTCIntersectContext base;
    Query* query;
    double scale;  // from distances along the query's ray to those along Embree's,
    double start;  // which begins here

    // How far Embree's ray needs to look.
    float far() const { return static_cast<float>(std::max(0.0, query->nearest.distance * scale - start) + slack); }
  };

  const PlacedShape* shapes;
  Frame frame;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  explicit Tree(const std::vector<PlacedShape>& all) : shapes(all.data()), frame(frame_around(all)) {
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
    const Box& of = tree.shapes[args->primID].box;
    const Vec3d low = (of.low - tree.frame.center) * tree.frame.inverse_radius;
    const Vec3d high = (of.high - tree.frame.center) * tree.frame.inverse_radius;
    RTCBounds& box = *args->bounds_o;
    box.lower_x = static_cast<float>(low.x - slack), box.upper_x = static_cast<float>(high.x + slack);
    box.lower_y = static_cast<float>(low.y - slack), box.upper_y = static_cast<float>(high.y + slack);
    box.lower_z = static_cast<float>(low.z - slack), box.upper_z = static_cast<float>(high.z + slack);
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (!args->valid[0]) return;
    const auto* context = reinterpret_cast<const Context*>(args->context);
    const Tree& tree = *static_cast<const Tree*>(args->geometryUserPtr);
    context->query->consider(tree.shapes[args->primID], static_cast<int>(args->primID));
    auto* ray = reinterpret_cast<RTCRayHit*>(args->rayhit);
    ray->ray.tfar = std::min(ray->ray.tfar, context->far());
  }

  // Shows every shape that the ray may meet first to consider().
  void search(Query& query) const {
    Vec3d origin = (query.origin - frame.center) * frame.inverse_radius;
    double start = 0;
    if (dot(origin, origin) > 1) {
      const auto ball = sphere_roots(origin, query.direction, Vec3d{}, 1 + slack);
      if (!(ball.half_chord_squared >= 0)) return;
      const double half = std::sqrt(ball.half_chord_squared);
      if (ball.middle + half < 0) return;
      start = std::max(0.0, ball.middle - half);
      origin = origin + query.direction * start;
    }
    Context context{{}, &query, frame.inverse_radius, start};
    if (query.nearest.distance * context.scale < start - slack) return;
    rtcInitIntersectContext(&context.base);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x), ray.ray.org_y = static_cast<float>(origin.y);
    ray.ray.org_z = static_cast<float>(origin.z);
    ray.ray.dir_x = static_cast<float>(query.direction.x), ray.ray.dir_y = static_cast<float>(query.direction.y);
    ray.ray.dir_z = static_cast<float>(query.direction.z);
    ray.ray.tnear = 0, ray.ray.tfar = context.far();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context.base, &ray);
  }
};

ShapeSet::ShapeSet(std::vector<PlacedShape> shapes, ShapeSearch search) : shapes_(std::move(shapes)) {
  const bool is_few = shapes_.size() <= static_cast<std::size_t>(few);
  if (search == ShapeSearch::tree || (search == ShapeSearch::by_number && !is_few)) {
    tree_ = std::make_unique<Tree>(shapes_);
    if (!tree_->scene) tree_.reset();  // no Embree device: one by one is slower, and right
  }
}
ShapeSet::~ShapeSet() = default;
ShapeSet::ShapeSet(ShapeSet&&) noexcept = default;
ShapeSet& ShapeSet::operator=(ShapeSet&&) noexcept = default;

std::optional<ShapeHit> ShapeSet::next(math::Vec3d origin, math::Vec3d direction, int from, double limit) const {
  Query query{.origin = origin, .direction = direction, .from = from, .nearest = {limit, no_shape}};
  if (tree_)
    tree_->search(query);
  else
    for (std::size_t i = 0; i < shapes_.size(); ++i) query.consider(shapes_[i], static_cast<int>(i));
  if (query.nearest.shape == no_shape) return {};
  return query.nearest;
}

}  // namespace shabon::geometry
