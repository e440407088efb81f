#include "shabon/render/kernel/probe_tree.h"

#include <algorithm>
#include <cmath>

#include "shabon/render/comb.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

using math::Vec3d;

constexpr double least_cos = 1e-8;  // of the angle of incidence: R is 1 there to 1e-7, and every model is finite

// The paper's recursion does not end by itself, (13): a path that needs more events is dropped.
constexpr int two_beam_most_events = 16;

// An eye on the wall is on the side that it looks into.
bool holds(const geometry::SphereShape& sphere, const Vec3d& eye, const Vec3d& direction) {
  const Vec3d m = eye - sphere.center;
  const double excess = math::length(m) - sphere.radius;
  return excess < 0 || (excess == 0 && math::dot(m, direction) < 0);
}

}  // namespace

ProbeTree::ProbeTree(const scene::Scene& scene, const geometry::SphereSet& spheres, const WavelengthGroup& wavelengths)
    : scene_(scene), spheres_(spheres), films_(scene, wavelengths), amounts_(scene.environment.channels.size()) {
  for (const color::Spectrum& channel : scene.environment.channels) {
    std::array<double, probe_lanes> lanes;
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = at_wavelength(channel, wavelengths.nm[i]);
    channels_.push_back(ProbeLanes::load(lanes.data()));
  }
}

std::optional<ProbeLight> ProbeTree::trace(const ProbeStart& start, ProbeCut cut, std::uint64_t most_events) {
  cut_ = cut;
  light_ = {};
  open_count_ = 0;
  Branch first;
  first.origin = start.origin, first.direction = start.direction, first.s = start.s;
  first.row = {ProbeLanes(start.q0), ProbeLanes(start.q1), ProbeLanes(start.q2), ProbeLanes(0.0)};
  const auto shapes = spheres_.spheres();
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (holds(shapes[i], first.origin, first.direction)) first.holding.push_back(static_cast<int>(i));
  push(first);
  while (open_count_ > 0) {
    if (light_.film_events > most_events) return std::nullopt;
    std::swap(current_, open_[--open_count_]);
    follow(current_);
  }
  return light_;
}

ProbeTree::Branch& ProbeTree::push(const Branch& branch) {
  if (open_count_ == open_.size()) open_.emplace_back();
  return open_[open_count_++] = branch;
}

// To the next wall, or out to the environment.
void ProbeTree::follow(Branch& branch) {
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
void ProbeTree::turn_into_plane(Branch& branch, const Vec3d& normal) const {
  const Vec3d across = math::cross(branch.direction, normal);
  const double sine = math::length(across);
  if (sine < 1e-14) return;
  const Vec3d s = across * (1 / sine);
  const double c = math::dot(branch.s, s), k = math::dot(math::cross(branch.s, branch.direction), s);
  const double norm = c * c + k * k;
  branch.row = rotated(branch.row, (c * c - k * k) / norm, 2 * c * k / norm);
  branch.s = s;
}

void ProbeTree::split(Branch& branch, const Vec3d& normal, double along, int slot) {
  ++light_.film_events;
  const scene::Sphere& sphere = scene_.spheres[static_cast<std::size_t>(branch.from)];
  const auto film = static_cast<std::size_t>(sphere.first_film + slot);
  const double thickness_nm = film::thickness_nm(scene_.films[film].thickness, normal);
  const ProbeMueller blocks =
      films_.blocks(film, thickness_nm, std::clamp(std::abs(along), least_cos, 1.0), !branch.inward);
  const bool paper = scene_.render.interference == optics::Interference::two_beam;
  if (paper && branch.events >= two_beam_most_events) {
    ++light_.cut_branches;
    return;
  }
  const bool cut = branch.events >= cut_.most_events || !any(branch.row.q0 >= ProbeLanes(cut_.least_carried));
  ++branch.events;
  const ProbeRow back = through(branch.row, blocks.reflected);
  ProbeRow forth = through(branch.row, blocks.transmitted);
  if (cut) {
    ++light_.cut_branches;
    light_.passed_on += back.q0;
    const ProbeLanes kept = blocks.reflected.a + blocks.transmitted.a;
    forth = {back.q0 + forth.q0, back.q1 + forth.q1, branch.row.q2 * kept, branch.row.q3 * kept};
  } else {
    Branch& reflected = push(branch);
    reflected.row = back;
    // Unit length anew: a deviation would grow up to 18 times from wall to wall of a bubble.
    reflected.direction = math::normalize(branch.direction - normal * (2 * along));
    leave(reflected, sphere.film_count, slot, !branch.inward);
  }
  Branch& transmitted = push(branch);
  transmitted.row = forth;
  leave(transmitted, sphere.film_count, slot, branch.inward);
}

// On from the film `slot` of `branch.from`: to its neighbour on the same spot, or into or out of the sphere.
void ProbeTree::leave(Branch& branch, int films, int slot, bool inward) {
  const int next = slot + (inward ? 1 : -1);
  branch.inward = inward;
  branch.next_slot = next >= 0 && next < films ? next : -1;
  if (branch.next_slot >= 0) return;
  const auto at = std::lower_bound(branch.holding.begin(), branch.holding.end(), branch.from);
  const bool held = at != branch.holding.end() && *at == branch.from;
  if (inward && !held) branch.holding.insert(at, branch.from);
  if (!inward && held) branch.holding.erase(at);
}

void ProbeTree::add_environment(const Branch& branch) {
  scene_.environment.coefficients(branch.direction, std::span<double>(amounts_));
  ProbeLanes radiance(0.0);
  for (std::size_t k = 0; k < channels_.size(); ++k)
    if (amounts_[k] != 0) radiance += channels_[k] * amounts_[k];
  light_.radiance += branch.row.q0 * radiance;
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
