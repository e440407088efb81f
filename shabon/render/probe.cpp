#include "shabon/render/probe.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "shabon/base/parallel.h"
#include "shabon/math/normal_to.h"
#include "shabon/render/idle_films.h"
#include "shabon/render/kernel/probe_tree.h"
#include "shabon/render/kernel/scattering/probe_walks.h"

namespace shabon::render {

namespace {

using math::Vec3d;

// The cuts of equation (27), the exact one first. Films that face each other near grazing incidence hand light to and
// fro for ever more branches: a tree of too many events is cut at the next larger share.
constexpr ProbeCut cuts[] = {{1e-7, 1 << 17}, {1e-6, 1 << 15}, {1e-5, 1 << 13}, {1e-4, 1 << 11}, {1e-3, 1 << 9}};
constexpr std::size_t last_cut = std::size(cuts) - 1;

// Film events of all groups of wavelengths together: a few seconds. And what is spent before the count is looked at.
constexpr std::uint64_t most_events = 20'000'000, first_try = 20'000;

class Probe {
 public:
  Probe(const scene::Scene& scene, const ProbeStart& start, std::span<const double> wavelengths_nm)
      : scene_(scene), start_(start), wavelengths_nm_(wavelengths_nm), spheres_(shapes(scene)) {}

  ProbeResult trace() {
    const std::size_t groups = (wavelengths_nm_.size() + probe_lanes - 1) / probe_lanes;
    ProbeResult result;
    result.radiance.resize(wavelengths_nm_.size());
    if (groups == 0) return result;
    const std::size_t chosen = groups > 1 ? affordable_cut(spread_wavelengths(), most_events / groups)
                                          : affordable_cut(wavelengths_nm_, most_events);
    std::vector<ProbeLight> lights(groups);
    parallel_for(groups, 0, [&](std::size_t g) { lights[g] = light_of(group(g), chosen); });
    for (std::size_t g = 0; g < groups; ++g) {
      result.film_events += lights[g].film_events, result.cut_branches += lights[g].cut_branches;
      for (std::size_t i = 0; i < group(g).size(); ++i) {
        result.radiance[g * probe_lanes + i] = lights[g].radiance[static_cast<int>(i)];
        result.cut_carried = std::max(result.cut_carried, lights[g].passed_on[static_cast<int>(i)]);
      }
    }
    result.least_carried = cuts[chosen].least_carried;
    return result;
  }

 private:
  static std::vector<geometry::SphereShape> shapes(const scene::Scene& scene) {
    std::vector<geometry::SphereShape> result;
    for (const scene::Sphere& sphere : scene.spheres) result.push_back({sphere.center, sphere.radius});
    return result;
  }

  std::span<const double> group(std::size_t index) const {
    const std::size_t first = index * probe_lanes;
    return wavelengths_nm_.subspan(first, std::min<std::size_t>(probe_lanes, wavelengths_nm_.size() - first));
  }

  std::vector<double> spread_wavelengths() const {
    std::vector<double> result;
    for (std::size_t i = 0; i < probe_lanes; ++i)
      result.push_back(wavelengths_nm_[i * (wavelengths_nm_.size() - 1) / (probe_lanes - 1)]);
    return result;
  }

  // The first of the cuts whose tree stays within the number of events. Small trees are tried as they are, large ones
  // grown from the coarsest cut, so that little is spent in vain.
  std::size_t affordable_cut(std::span<const double> wavelengths_nm, std::uint64_t most) const {
    ProbeTree tree(scene_, spheres_, WavelengthGroup(wavelengths_nm));
    if (tree.trace(start_, cuts[0], std::min(first_try, most))) return 0;
    std::size_t chosen = last_cut;
    while (chosen > 0 && tree.trace(start_, cuts[chosen - 1], most)) --chosen;
    return chosen;
  }

  ProbeLight light_of(std::span<const double> wavelengths_nm, std::size_t cut) const {
    ProbeTree tree(scene_, spheres_, WavelengthGroup(wavelengths_nm));
    return *tree.trace(start_, cuts[cut], std::numeric_limits<std::uint64_t>::max());
  }

  const scene::Scene& scene_;
  ProbeStart start_;
  std::span<const double> wavelengths_nm_;
  geometry::SphereSet spheres_;
};

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

ProbeStart start_of(const scene::Scene& scene, const ProbeRay& ray) {
  ProbeStart start;
  start.origin = ray.origin;
  start.direction = math::normalize(ray.direction);
  start.s = math::any_normal_to(start.direction);
  const auto& camera = scene.camera;
  if (ray.through_camera && camera.polarizer_rad) {
    start.s = camera.polarizer_right(start.direction);
    const double turn = 2 * *camera.polarizer_rad;
    start.q0 = 0.5, start.q1 = 0.5 * std::cos(turn), start.q2 = 0.5 * std::sin(turn);
  }
  return start;
}

WalkStart walk_start_of(const ProbeStart& start) {
  WalkStart walk;
  walk.origin = start.origin, walk.direction = start.direction;
  const auto lanes = [](double x) { return Lanes(static_cast<float>(x)); };
  walk.row = {{lanes(start.q0), lanes(start.q1), lanes(start.q2), Lanes(0.0f)}, start.s, start.q0 != 1};
  walk.carried = static_cast<float>(start.q0);
  return walk;
}

}  // namespace

ProbeRay pixel_ray(const scene::Scene& scene, double x, double y) {
  const scene::CameraRay ray = scene.camera.ray(x, y);
  return {ray.origin, ray.direction, true};
}

Result<ProbeResult> probe(const scene::Scene& scene, const ProbeRay& ray, std::span<const double> wavelengths_nm,
                          const ProbeOptions& options) {
  if (!finite(ray.origin) || !finite(ray.direction) || !(math::length(ray.direction) > 0))
    return fail(Failure::usage, "expected a ray with finite numbers and a direction other than 0 0 0");
  for (const double nm : wavelengths_nm)
    if (!(nm >= optics::rendered_range_nm.first_nm && nm <= optics::rendered_range_nm.last_nm))
      return fail(Failure::usage, "expected wavelengths from 360 to 830 nm");
  if (const Status ran = check_films_ran(scene); !ran) return ran.errors();
  const ProbeStart start = start_of(scene, ray);
  if (!scene.objects.empty()) return probe_walks(scene, walk_start_of(start), wavelengths_nm, options);
  return Probe(scene, start, wavelengths_nm).trace();
}

}  // namespace shabon::render
