// What is left over of light on a rough boundary once its facets have sent on what they scatter a single time: nothing
// of what the film absorbs, (61). Per wavelength, over the angle, the roughness and the thickness of a layer that
// varies.
#pragma once

#include <functional>
#include <vector>

#include "shabon/render/kernel/lanes.h"

namespace shabon::render {

struct FacetShares;

inline namespace SHABON_REGISTERS {

// Evenly spaced nodes from `first` to `last`.
struct Nodes {
  double first = 0, last = 0;
  int count = 0;

  double at(int i) const { return count > 1 ? first + (last - first) * i / (count - 1) : first; }
};

// Reflected and transmitted power of unpolarised light.
struct BoundaryPowers {
  Lanes reflected, transmitted;
};

class RestTable {
 public:
  // One side of a boundary; `powers` tells what it does per comb, cosine and thickness, from several threads at once.
  struct Side {
    Nodes alpha, thickness_nm;
    std::size_t combs = 0;
    bool refracts = false;     // the facets bend the light they let through; else all that they do not mirror goes on
    double near_over_far = 1;  // mean over the wavelengths
    // Per comb, where wavelengths differ in it: each has its own critical angle, at which everything changes.
    std::vector<LanesD> each_near_over_far = {};
    std::function<BoundaryPowers(std::size_t comb, double cos, double thickness_nm)> powers;
  };

  RestTable() = default;
  explicit RestTable(const Side& side);

  bool empty() const { return rest_.empty(); }
  // Refracting facets: the light lost to single scattering. Else: all that is not mirrored once or absorbed.
  Lanes at(std::size_t comb, double cos, double alpha, double thickness_nm) const;
  // Its mean over a diffuse field.
  Lanes mean(std::size_t comb, double alpha, double thickness_nm) const;

  // About what facets mirror and refract a single time, over all wavelengths.
  struct Once {
    float mirrored = 0, refracted = 0;
    float reflectance = 0;  // of the facets that are seen
  };
  Once once(double cos, double alpha, double thickness_nm) const;
  // How willingly a facet is chosen to mirror, or to refract, light at this cosine to its normal, in 0..1. Near total
  // reflection facets differ much: without a choice the weights of a path trapped inside would run away.
  double choice(bool refract, double cos, double alpha, double thickness_nm) const;
  double mean_choice(bool refract, double cos_o, double alpha, double thickness_nm) const;  // over those seen
  // A cosine about as often as at() times the cosine asks for, and its density per solid angle.
  double sample_cosine(double u, double alpha, double thickness_nm) const;
  double density(double cos, double alpha, double thickness_nm) const;

 private:
  static constexpr int cosine_nodes = 48;  // at squares, denser towards grazing

  struct Means {
    Once once[cosine_nodes];
    float below[cosine_nodes];  // the share of sample_cosine below this node
  };

  struct Shares;  // of facets, for a few ratios of the indices

  void fill(const Side& side, const Shares& shares, std::size_t thickness, std::size_t comb);
  void fill_means(std::size_t node);
  const Means& means_near(double alpha, double thickness_nm) const;
  std::size_t row(std::size_t thickness, std::size_t alpha, std::size_t comb) const;
  template <class Read>
  auto between_rows(std::size_t comb, double alpha, double thickness_nm, const Read& read) const;

  Nodes alpha_, thickness_nm_;
  double near_over_far_ = 1;
  bool chooses_ = false;
  std::size_t combs_ = 0;
  std::vector<Lanes> rest_;              // [row * cosine_nodes + cosine]
  std::vector<Lanes> means_;             // [row]
  std::vector<Once> once_;               // as rest_, while the table is made
  std::vector<float> facets_;            // reflectance over all wavelengths [thickness * facet_nodes + facet]
  std::vector<Means> over_wavelengths_;  // [row / combs]
};

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
