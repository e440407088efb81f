#include "shabon/geometry/coincidence.h"

#include <algorithm>
#include <numeric>

namespace shabon::geometry {

namespace {

using math::Vec3d;

constexpr double tolerance = coincidence_tolerance;
constexpr int ellipse_directions = 720;

double size_of(const PlacedShape& s) { return math::length(s.box.high - s.box.low); }

// ---- Flat shapes: convex but for a disk's hole. Two of them are apart where a line of their plane parts them; for
// polygons one of their edges does, for ellipses one of many tangents.

// Points, in order, whose hull is the canonical shape, or nearly so.
std::vector<Vec3d> hull(const Triangle&) { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}; }
std::vector<Vec3d> hull(const Quad&) { return {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}; }
std::vector<Vec3d> hull(const Disk&) {
  std::vector<Vec3d> points;
  for (int i = 0; i < ellipse_directions; ++i) {
    const auto [c, s] = turn_by(360.0 * i / ellipse_directions);
    points.push_back({c, s, 0});
  }
  return points;
}
template <class Curved>
requires(!Curved::flat) std::vector<Vec3d> hull(const Curved&) { return {}; }

std::vector<Vec3d> hull_of(const PlacedShape& placed) {
  std::vector<Vec3d> points = std::visit([](const auto& s) { return hull(s); }, placed.shape);
  for (Vec3d& p : points) p = apply_point(placed.to_world, p);
  return points;
}

// The normals, in the plane and of unit length, of the lines that may part this shape from another.
void add_parting_directions(std::vector<Vec3d>& directions, const PlacedShape& placed, Vec3d plane_normal) {
  const std::vector<Vec3d> corners = hull_of(placed);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
    directions.push_back(math::normalize(cross(plane_normal, edge)));
  }
}

struct Reach {
  double low, high;  // from a common point
};

Reach reach_of(const PlacedShape& placed, Vec3d direction, Vec3d from) {
  const Vec3d g = apply_transposed(placed.to_world, direction);
  const double at = dot(placed.to_world.origin - from, direction);
  return std::visit([&](const auto& s) { return Reach{at - support(s, -g), at + support(s, g)}; }, placed.shape);
}

bool lies_in_hole(const PlacedShape& placed, const PlacedShape& ring) {
  const Disk* disk = std::get_if<Disk>(&ring.shape);
  if (!disk || !(disk->hole > 0)) return false;
  const std::vector<Vec3d> hull = hull_of(placed);
  return std::all_of(hull.begin(), hull.end(), [&](Vec3d p) {
    const Vec3d at = apply_vector(ring.to_object, p - ring.to_world.origin);
    return std::hypot(at.x, at.y) <= disk->hole + tolerance;
  });
}

bool lie_in_one_plane(const PlacedShape& a, const PlacedShape& b, Vec3d normal) {
  const auto [low, high] = reach_of(b, normal, a.to_world.origin);
  const auto [own_low, own_high] = reach_of(a, apply_normal(b.to_world, {0, 0, 1}), b.to_world.origin);
  const double most = tolerance * std::min(size_of(a), size_of(b));
  return std::max({std::abs(low), std::abs(high)}) <= most || std::max({std::abs(own_low), std::abs(own_high)}) <= most;
}

template <class Flat>
requires(Flat::flat) bool share_a_piece(const Flat&, const PlacedShape& a, const PlacedShape& b) {
  const Vec3d normal = apply_normal(a.to_world, {0, 0, 1});
  if (!lie_in_one_plane(a, b, normal)) return false;
  std::vector<Vec3d> directions;
  add_parting_directions(directions, a, normal);
  add_parting_directions(directions, b, normal);
  const double least = tolerance * std::min(size_of(a), size_of(b));
  for (const Vec3d direction : directions) {
    const Reach of_a = reach_of(a, direction, a.to_world.origin), of_b = reach_of(b, direction, a.to_world.origin);
    if (std::min(of_a.high, of_b.high) - std::max(of_a.low, of_b.low) <= least) return false;
  }
  return !lies_in_hole(a, b) && !lies_in_hole(b, a);
}

// ---- Curved shapes: seen from a's own coordinates, the map of b must be one of the symmetries of the surface.

Affine seen_from(const PlacedShape& a, const PlacedShape& b) {
  const Affine& m = b.to_world;
  const auto turn = [&](Vec3d v) { return apply_vector(a.to_object, v); };
  return {turn(m.x), turn(m.y), turn(m.z), turn(m.origin - a.to_world.origin)};
}

bool is_zero(double x) { return std::abs(x) <= tolerance; }
bool is_one(double x) { return std::abs(x - 1) <= tolerance; }

bool share_a_piece(const SphereCap&, const PlacedShape& a, const PlacedShape& b) {
  const Affine m = seen_from(a, b);
  const bool same_sphere = is_zero(math::length(m.origin)) && is_one(dot(m.x, m.x)) && is_one(dot(m.y, m.y)) &&
                           is_one(dot(m.z, m.z)) && is_zero(dot(m.x, m.y)) && is_zero(dot(m.y, m.z)) &&
                           is_zero(dot(m.z, m.x));
  if (!same_sphere) return false;
  // Caps overlap where their axes are nearer than their angular radii together. They touch at most with equality.
  const auto angle = [](const PlacedShape& s) {
    return std::acos(std::clamp(std::get<SphereCap>(s.shape).cos_cap, -1.0, 1.0));
  };
  const double between = std::atan2(std::hypot(m.y.x, m.y.z), m.y.y);
  return between < angle(a) + angle(b) - tolerance;
}

bool share_a_piece(const Cylinder&, const PlacedShape& a, const PlacedShape& b) {
  const Affine m = seen_from(a, b);
  const auto flat_dot = [](Vec3d p, Vec3d q) { return p.x * q.x + p.z * q.z; };
  const bool same_tube = is_zero(m.y.x) && is_zero(m.y.z) && is_zero(m.origin.x) && is_zero(m.origin.z) &&
                         is_one(flat_dot(m.x, m.x)) && is_one(flat_dot(m.z, m.z)) && is_zero(flat_dot(m.x, m.z));
  if (!same_tube) return false;
  const double slant = std::hypot(m.x.y, m.z.y);  // by which the ends of one lean against those of the other
  return std::abs(m.origin.y) - slant < 1 + std::abs(m.y.y) - tolerance;
}

bool share_a_piece(const Torus& torus, const PlacedShape& a, const PlacedShape& b) {
  const Affine m = seen_from(a, b);
  const auto flat_dot = [](Vec3d p, Vec3d q) { return p.x * q.x + p.z * q.z; };
  return is_zero(torus.tube - std::get<Torus>(b.shape).tube) && is_zero(math::length(m.origin)) &&
         is_one(std::abs(m.y.y)) && is_zero(m.y.x) && is_zero(m.y.z) && is_zero(m.x.y) && is_zero(m.z.y) &&
         is_one(flat_dot(m.x, m.x)) && is_one(flat_dot(m.z, m.z)) && is_zero(flat_dot(m.x, m.z));
}

// Copies only: lobes that make the same surface otherwise are not looked for.
bool share_a_piece(const LobedSphere& lobed, const PlacedShape& a, const PlacedShape& b) {
  const Affine m = seen_from(a, b);
  const auto& other = std::get<LobedSphere>(b.shape);
  return lobed.mean == other.mean && lobed.lobes == other.lobes && is_zero(math::length(m.origin)) &&
         is_zero(math::length(m.x - Vec3d{1, 0, 0})) && is_zero(math::length(m.y - Vec3d{0, 1, 0})) &&
         is_zero(math::length(m.z - Vec3d{0, 0, 1}));
}

bool coincide(const PlacedShape& a, const PlacedShape& b) {
  const auto is_flat = [](const PlacedShape& s) { return std::visit([](const auto& t) { return t.flat; }, s.shape); };
  if (a.shape.index() != b.shape.index() && !(is_flat(a) && is_flat(b))) return false;
  return std::visit([&](const auto& s) { return share_a_piece(s, a, b); }, a.shape);
}

bool boxes_meet(const PlacedShape& a, const PlacedShape& b) {
  const double most = tolerance * std::min(size_of(a), size_of(b));
  const auto meet = [most](double low_a, double high_a, double low_b, double high_b) {
    return low_a <= high_b + most && low_b <= high_a + most;
  };
  return meet(a.box.low.x, a.box.high.x, b.box.low.x, b.box.high.x) &&
         meet(a.box.low.y, a.box.high.y, b.box.low.y, b.box.high.y) &&
         meet(a.box.low.z, a.box.high.z, b.box.low.z, b.box.high.z);
}

}  // namespace

std::vector<std::pair<int, int>> coincident(std::span<const PlacedShape> shapes) {
  const auto at = [&](int i) -> const PlacedShape& { return shapes[static_cast<std::size_t>(i)]; };
  std::vector<int> by_left(shapes.size());
  std::iota(by_left.begin(), by_left.end(), 0);
  std::sort(by_left.begin(), by_left.end(), [&](int i, int j) { return at(i).box.low.x < at(j).box.low.x; });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < by_left.size(); ++k) {
    const PlacedShape& a = at(by_left[k]);
    const double right = a.box.high.x + tolerance * size_of(a);
    for (std::size_t l = k + 1; l < by_left.size() && at(by_left[l]).box.low.x <= right; ++l)
      if (boxes_meet(a, at(by_left[l])) && coincide(a, at(by_left[l])))
        pairs.push_back(std::minmax(by_left[k], by_left[l]));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace shabon::geometry
