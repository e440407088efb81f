// Rough boundaries: the GGX distribution of microfacets (Walter, Marschner, Li, Torrance 2007, "Microfacet models for
// refraction through rough surfaces"), its height-correlated masking, and sampling of the visible normals (Heitz 2018,
// "Sampling the GGX distribution of visible normals"). Directions are in the frame whose z axis is the normal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shabon/math/vec.h"

namespace shabon::render {

// Below this alpha a boundary is treated as smooth: its blur is a tenth of the sun's disk.
inline constexpr double least_alpha = 1e-3;

// D of the normal h, per solid angle; alpha > 0.
inline double ggx_density(const math::Vec3d& h, double alpha) {
  const double a2 = alpha * alpha, x = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
  return 1 / (std::numbers::pi * a2 * x * x);
}

// Smith's Lambda for a direction of cosine `cos` to the normal.
inline double ggx_lambda(double cos, double alpha) {
  const double cos2 = std::max(cos * cos, 1e-12), sin2 = 1 - std::min(1.0, cos2);
  return (std::sqrt(1 + alpha * alpha * sin2 / cos2) - 1) / 2;
}

// The share of the facets facing a direction that is not hidden from it.
inline double ggx_visible(double cos, double alpha) { return 1 / (1 + ggx_lambda(cos, alpha)); }

// Of those visible from `o`, the share that is visible from `i` too: on the same side, and on the other.
inline double ggx_also_visible(double cos_o, double cos_i, double alpha) {
  return (1 + ggx_lambda(cos_o, alpha)) / (1 + ggx_lambda(cos_o, alpha) + ggx_lambda(cos_i, alpha));
}
inline double ggx_also_visible_behind(double cos_o, double cos_i, double alpha) {
  const double a = 1 + ggx_lambda(cos_o, alpha), b = 1 + ggx_lambda(cos_i, alpha);
  return a * std::beta(a, b);  // height-correlated, Walter's model with heights from -1 to 1
}

// A normal seen from `o` (o.z > 0), with density ggx_visible D max(0, o.h)/o.z.
inline math::Vec3d ggx_sample_visible(const math::Vec3d& o, double alpha, double u1, double u2) {
  const math::Vec3d stretched = math::normalize(math::Vec3d{alpha * o.x, alpha * o.y, o.z});
  const double across = stretched.x * stretched.x + stretched.y * stretched.y;
  const math::Vec3d t1 =
      across > 0 ? math::Vec3d{-stretched.y, stretched.x, 0} * (1 / std::sqrt(across)) : math::Vec3d{1, 0, 0};
  const math::Vec3d t2 = math::cross(stretched, t1);
  const double r = std::sqrt(u1), phi = 2 * std::numbers::pi * u2;
  const double x = r * std::cos(phi), half = 0.5 * (1 + stretched.z);
  const double y = (1 - half) * std::sqrt(std::max(0.0, 1 - x * x)) + half * r * std::sin(phi);
  const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  const math::Vec3d h = t1 * x + t2 * y + stretched * z;
  return math::normalize(math::Vec3d{alpha * h.x, alpha * h.y, std::max(1e-12, h.z)});
}

inline double ggx_visible_density(const math::Vec3d& o, const math::Vec3d& h, double alpha) {
  return ggx_visible(o.z, alpha) * ggx_density(h, alpha) * std::max(0.0, math::dot(o, h)) / o.z;
}

// What single scattering returns of white light that arrives at cosine `cos_o` on a rough perfect mirror (the rest is
// lost between the facets), and its mean over a diffuse field. Interpolated in tables made at the first call.
double single_scattering(double cos_o, double alpha);
double mean_single_scattering(double alpha);

// What becomes of light from one direction at rough facets, by the cosine between it and the facet's normal: hat
// functions that crowd above the critical angle, where reflection changes fast. All facets seen together count as 1.
inline constexpr int facet_nodes = 48;

struct FacetCosines {
  double critical = 0;  // cosine of the critical angle; 0 from the thinner medium
  int below = 0;        // nodes below it, where all is reflected

  explicit FacetCosines(double near_over_far)
      : critical(near_over_far > 1 ? std::sqrt(1 - 1 / (near_over_far * near_over_far)) : 0),
        below(critical > 0 ? 8 : 0) {}
  double at(int k) const {
    const double above = (k - below) / (facet_nodes - 1.0 - below);
    return k < below ? critical * k / below : critical + (1 - critical) * above * above;
  }
  double place(double cos) const {
    if (cos < critical) return cos / critical * below;
    return below + std::sqrt((cos - critical) / (1 - critical)) * (facet_nodes - 1 - below);
  }
};

struct FacetShares {
  std::array<float, facet_nodes> seen{};
  std::array<float, facet_nodes> lost_reflected{};  // of what such facets mirror: meets other facets
  std::array<float, facet_nodes> lost_refracted{};  // of what they refract
};

// For light at cosine `cos_o` in a medium whose index is `near_over_far` times that behind the facets.
FacetShares facet_shares(double cos_o, double alpha, double near_over_far);

}  // namespace shabon::render
