#include "shabon/render/probe.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "shabon/geometry/sphere_set.h"
#include "shabon/optics/reference/mueller.h"
#include "shabon/render/comb.h"

namespace shabon::render {

namespace {

using math::Vec3d;

// Where the tree is cut, equation (27): the film then passes R + T straight on.
constexpr double least_carried = 1e-7;
constexpr int most_events = 1024;

constexpr double least_cos = 1e-8;  // of the angle of incidence: R is 1 there to 1e-7, and every model is finite

// Films that face each other near grazing incidence hand light to and fro for ever more branches. A tree of more events
// than this is cut earlier: the bound doubles with every further step.
constexpr double large_tree_events = 1 << 19, large_tree_step = 1 << 17;

// The paper's recursion does not end by itself, (13): a path that needs more events is dropped.
constexpr int two_beam_most_events = 16;

struct Stokes {
  double q0 = 0, q1 = 0, q2 = 0, q3 = 0;
};

// One branch of the tree on its way to the next wall.
struct Branch {
  Vec3d origin, direction;
  Vec3d s;                   // the rows' s axis
  std::vector<int> holding;  // the spheres that it is in, in rising order
  int from = geometry::no_sphere;
  int next_slot = -1;   // film of `from` on the same spot that is met next, or -1
  bool inward = false;  // on its way through such films
  int depth = 0;
  std::vector<Stokes> rows;  // one per wavelength
};

Stokes rotated(const Stokes& q, double cos_2phi, double sin_2phi) {
  return {q.q0, q.q1 * cos_2phi + q.q2 * sin_2phi, q.q2 * cos_2phi - q.q1 * sin_2phi, q.q3};
}

Stokes through(const Stokes& q, const optics::MuellerRow& m) {
  return {m.a * q.q0 + m.b * q.q1, m.b * q.q0 + m.a * q.q1, m.c * q.q2 + m.d * q.q3, m.c * q.q3 - m.d * q.q2};
}

Vec3d any_normal(const Vec3d& d) {
  return math::normalize(math::cross(d, std::abs(d.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
}

class Tree {
 public:
  Tree(const scene::Scene& scene, std::span<const double> wavelengths_nm)
      : scene_(scene), wavelengths_nm_(wavelengths_nm), spheres_(shapes(scene)) {
    for (const double nm : wavelengths_nm) outside_.push_back(scene.medium.index(nm));
    for (const scene::Film& film : scene.films) {
      std::vector<std::complex<double>>& n = films_.emplace_back();
      for (const double nm : wavelengths_nm) n.push_back(film.medium.index(nm));
    }
    result_.radiance.assign(wavelengths_nm.size(), 0.0);
  }

  ProbeResult trace(Branch first) {
    const auto shapes_in_scene = spheres_.spheres();
    for (std::size_t i = 0; i < shapes_in_scene.size(); ++i)
      if (holds(shapes_in_scene[i], first.origin, first.direction)) first.holding.push_back(static_cast<int>(i));
    open_.push_back(std::move(first));
    while (!open_.empty()) {
      Branch branch = std::move(open_.back());
      open_.pop_back();
      follow(branch);
    }
    return std::move(result_);
  }

 private:
  static std::vector<geometry::SphereShape> shapes(const scene::Scene& scene) {
    std::vector<geometry::SphereShape> result;
    for (const scene::Sphere& sphere : scene.spheres) result.push_back({sphere.center, sphere.radius});
    return result;
  }

  // An eye on the wall is on the side that it looks into.
  static bool holds(const geometry::SphereShape& sphere, const Vec3d& eye, const Vec3d& direction) {
    const Vec3d m = eye - sphere.center;
    const double excess = math::length(m) - sphere.radius;
    return excess < 0 || (excess == 0 && math::dot(m, direction) < 0);
  }

  void follow(Branch& branch) {
    geometry::WallHit hit{0, branch.from};
    if (branch.next_slot < 0) {
      const auto found = spheres_.next_wall(branch.origin, branch.direction, branch.from, branch.holding);
      if (!found) return add_environment(branch);
      hit = *found;
    }
    const scene::Sphere& sphere = scene_.spheres[static_cast<std::size_t>(hit.sphere)];
    const Vec3d point = branch.origin + branch.direction * hit.distance;
    const Vec3d normal = (point - sphere.center) * (1 / sphere.radius);
    const double along = math::dot(branch.direction, normal);
    const bool between_films = branch.next_slot >= 0;
    if (!between_films) branch.inward = !std::binary_search(branch.holding.begin(), branch.holding.end(), hit.sphere);
    const int slot = between_films ? branch.next_slot : branch.inward ? 0 : sphere.film_count - 1;
    turn_into_plane(branch, normal);
    branch.origin = point;
    branch.from = hit.sphere;
    split(branch, normal, along, slot);
  }

  // Equation (15). At normal incidence every plane will do.
  void turn_into_plane(Branch& branch, const Vec3d& normal) const {
    const Vec3d across = math::cross(branch.direction, normal);
    const double sine = math::length(across);
    if (sine < 1e-14) return;
    const Vec3d s = across * (1 / sine);
    const double c = math::dot(branch.s, s), k = math::dot(math::cross(branch.s, branch.direction), s);
    const double norm = c * c + k * k;
    for (Stokes& q : branch.rows) q = rotated(q, (c * c - k * k) / norm, 2 * c * k / norm);
    branch.s = s;
  }

  void split(Branch& branch, const Vec3d& normal, double along, int slot) {
    ++result_.film_events;
    const scene::Sphere& sphere = scene_.spheres[static_cast<std::size_t>(branch.from)];
    const auto film = static_cast<std::size_t>(sphere.first_film + slot);
    const double thickness_nm = film::thickness_nm(scene_.films[film].thickness, normal);
    const optics::Incidence incidence = optics::incidence_from_cos(std::clamp(std::abs(along), least_cos, 1.0));
    const bool paper = scene_.render.interference == optics::Interference::two_beam;
    const bool cut = carries_little(branch) || branch.depth >= (paper ? two_beam_most_events : most_events);
    if (cut) ++result_.cut_branches;
    if (cut && paper && branch.depth >= two_beam_most_events) return;
    Branch reflected = branch;
    for (std::size_t i = 0; i < branch.rows.size(); ++i) {
      const optics::FilmRows rows = optics::film_rows(scene_.render.interference, outside_[i], films_[film][i],
                                                      outside_[i], thickness_nm, incidence, wavelengths_nm_[i]);
      const Stokes q = branch.rows[i];
      const Stokes back = through(q, rows.reflected), forth = through(q, rows.transmitted);
      reflected.rows[i] = back;
      const double kept = rows.reflected.a + rows.transmitted.a;
      branch.rows[i] = cut ? Stokes{back.q0 + forth.q0, back.q1 + forth.q1, q.q2 * kept, q.q3 * kept} : forth;
    }
    // Unit length anew: a deviation would grow up to 18 times from wall to wall of a bubble.
    reflected.direction = math::normalize(branch.direction - normal * (2 * along));
    leave(branch, sphere.film_count, slot, branch.inward);
    leave(reflected, sphere.film_count, slot, !branch.inward);
    ++branch.depth, ++reflected.depth;
    if (!cut) open_.push_back(std::move(reflected));
    open_.push_back(std::move(branch));
  }

  // On from the film `slot` of `branch.from`: to its neighbour on the same spot, or into or out of the sphere.
  static void leave(Branch& branch, int films, int slot, bool inward) {
    const int next = slot + (inward ? 1 : -1);
    branch.inward = inward;
    branch.next_slot = next >= 0 && next < films ? next : -1;
    if (branch.next_slot >= 0) return;
    const auto at = std::lower_bound(branch.holding.begin(), branch.holding.end(), branch.from);
    const bool held = at != branch.holding.end() && *at == branch.from;
    if (inward && !held) branch.holding.insert(at, branch.from);
    if (!inward && held) branch.holding.erase(at);
  }

  bool carries_little(const Branch& branch) const {
    const double excess = (static_cast<double>(result_.film_events) - large_tree_events) / large_tree_step;
    const double least = excess > 0 ? least_carried * std::exp2(excess) : least_carried;
    return std::all_of(branch.rows.begin(), branch.rows.end(), [&](const Stokes& q) { return !(q.q0 >= least); });
  }

  void add_environment(const Branch& branch) {
    const auto& channels = scene_.environment.channels;
    std::vector<double> amount(channels.size());
    scene_.environment.coefficients(branch.direction, std::span<double>(amount));
    for (std::size_t i = 0; i < wavelengths_nm_.size(); ++i) {
      double radiance = 0;
      for (std::size_t k = 0; k < channels.size(); ++k)
        if (amount[k] != 0) radiance += amount[k] * at_wavelength(channels[k], wavelengths_nm_[i]);
      result_.radiance[i] += branch.rows[i].q0 * radiance;
    }
  }

  const scene::Scene& scene_;
  std::span<const double> wavelengths_nm_;
  geometry::SphereSet spheres_;
  std::vector<std::complex<double>> outside_;
  std::vector<std::vector<std::complex<double>>> films_;
  std::vector<Branch> open_;
  ProbeResult result_;
};

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

ProbeRay pixel_ray(const scene::Scene& scene, double x, double y) {
  return {scene.camera.position, math::normalize(scene.camera.through(x, y)), true};
}

Result<ProbeResult> probe(const scene::Scene& scene, const ProbeRay& ray, std::span<const double> wavelengths_nm) {
  if (!finite(ray.origin) || !finite(ray.direction) || !(math::length(ray.direction) > 0))
    return fail(Failure::usage, "expected a ray with finite numbers and a direction other than 0 0 0");
  for (const double nm : wavelengths_nm)
    if (!(nm >= optics::rendered_range_nm.first_nm && nm <= optics::rendered_range_nm.last_nm))
      return fail(Failure::usage, "expected wavelengths from 360 to 830 nm");
  Branch first;
  first.origin = ray.origin;
  first.direction = math::normalize(ray.direction);
  first.s = any_normal(first.direction);
  Stokes start{1, 0, 0, 0};
  const auto& camera = scene.camera;
  if (ray.through_camera && camera.polarizer_rad) {
    first.s = math::normalize(camera.right - first.direction * math::dot(camera.right, first.direction));
    const double turn = 2 * *camera.polarizer_rad;
    start = {0.5, 0.5 * std::cos(turn), 0.5 * std::sin(turn), 0};
  }
  first.rows.assign(wavelengths_nm.size(), start);
  return Tree(scene, wavelengths_nm).trace(std::move(first));
}

}  // namespace shabon::render
