// The split tree of one exact ray, for a group of wavelengths at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shabon/geometry/sphere_set.h"
#include "shabon/math/vec.h"
#include "shabon/optics/packet/stokes_row.h"
#include "shabon/render/kernel/probe_films.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

using ProbeRow = optics::StokesRow<probe_lanes, double>;

// Where a branch is cut, equation (27): the film then passes R + T straight on.
struct ProbeCut {
  double least_carried;  // less than this at every wavelength
  int most_events;       // along one path
};

// The first branch, from the eye.
struct ProbeStart {
  math::Vec3d origin, direction;
  math::Vec3d s;  // the axis that q1 counts from
  double q0 = 1, q1 = 0, q2 = 0;
};

struct ProbeLight {
  ProbeLanes radiance{0.0};
  ProbeLanes passed_on{0.0};  // the share of the light that a cut film should have reflected and passed on
  std::uint64_t film_events = 0, cut_branches = 0;
};

class ProbeTree {
 public:
  ProbeTree(const scene::Scene& scene, const geometry::SphereSet& spheres, const WavelengthGroup& wavelengths);

  // The light along the ray; nothing when the tree has more film events than `most_events`.
  std::optional<ProbeLight> trace(const ProbeStart& start, ProbeCut cut, std::uint64_t most_events);

 private:
  // One branch on its way to the next wall.
  struct Branch {
    math::Vec3d origin, direction;
    math::Vec3d s;
    int from = geometry::no_sphere;
    int next_slot = -1;   // film of `from` on the same spot that is met next, or -1
    bool inward = false;  // on its way through such films
    int events = 0;
    ProbeRow row;
    std::vector<int> holding;  // the spheres that it is in, in rising order
  };

  Branch& push(const Branch& branch);
  void follow(Branch& branch);
  void turn_into_plane(Branch& branch, const math::Vec3d& normal) const;
  void split(Branch& branch, const math::Vec3d& normal, double along, int slot);
  void add_environment(const Branch& branch);
  static void leave(Branch& branch, int films, int slot, bool inward);

  const scene::Scene& scene_;
  const geometry::SphereSet& spheres_;
  ProbeFilms films_;
  std::vector<ProbeLanes> channels_;  // of the environment
  std::vector<double> amounts_;       // of each channel, in one direction
  ProbeCut cut_{};
  ProbeLight light_;
  std::vector<Branch> open_;  // the first open_count_ wait; the others keep their memory for later ones
  std::size_t open_count_ = 0;
  Branch current_;
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
