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

struct Stokes {
  double q0 = 0, q1 = 0, q2 = 0, q3 = 0;
};

// One branch of the tree on its way to the next wall.
struct Branch {
  Vec3d origin, direction;
  Vec3d s;                      // the rows' s axis
  int from = geometry::no_sphere;
  int next_slot = -1;           // film of `from` on the same spot that is met next, or -1
  int depth = 0;
  std::vector<Stokes> rows;     // one per wavelength
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

  void follow(Branch& branch) {
    geometry::WallHit hit{0, branch.from};
    if (branch.next_slot < 0) {
      const auto found = spheres_.next_wall(branch.origin, branch.direction, branch.from);
      if (!found) return add_environment(branch);
      hit = *found;
    }
    const scene::Sphere& sphere = scene_.spheres[static_cast<std::size_t>(hit.sphere)];
    const Vec3d point = branch.origin + branch.direction * hit.distance;
    const Vec3d normal = (point - sphere.center) * (1 / sphere.radius);
    const double along = math::dot(branch.direction, normal);
    const int slot = branch.next_slot >= 0 ? branch.next_slot : along < 0 ? 0 : sphere.film_count - 1;
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
    const optics::Incidence incidence = optics::incidence_from_cos(std::min(std::abs(along), 1.0));
    double carried = 0;
    for (const Stokes& q : branch.rows) carried = std::max(carried, q.q0);
    const bool cut = carried < least_carried || branch.depth >= most_events;
    if (cut) ++result_.cut_branches;
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
    reflected.direction = branch.direction - normal * (2 * along);
    const int films = sphere.film_count;
    const auto slot_after = [&](bool inward) {
      const int next = slot + (inward ? 1 : -1);
      return next >= 0 && next < films ? next : -1;
    };
    branch.next_slot = slot_after(along < 0);
    reflected.next_slot = slot_after(along >= 0);
    ++branch.depth, ++reflected.depth;
    if (!cut) open_.push_back(std::move(reflected));
    open_.push_back(std::move(branch));
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
