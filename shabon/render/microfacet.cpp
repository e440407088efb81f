#include "shabon/render/microfacet.h"

#include <array>

namespace shabon::render {

namespace {

// Nodes over the cosine (at squares, denser towards grazing) and over alpha.
constexpr int cosine_nodes = 32, alpha_nodes = 32;
constexpr int points_across = 32;  // the integral over visible normals takes the square of this many points

// use(h, weight) for facets seen from `o`, the weights' sum is 1. Points crowd where facets are steep: few, but they
// lose most.
template <class Use>
void over_visible(const math::Vec3d& o, double alpha, const Use& use) {
  for (int i = 0; i < points_across; ++i) {
    const double steep = 1 - (i + 0.5) / points_across, u1 = 1 - steep * steep;
    const double weight = 2 * steep / (points_across * points_across);
    for (int j = 0; j < points_across; ++j) use(ggx_sample_visible(o, alpha, u1, (j + 0.5) / points_across), weight);
  }
}

math::Vec3d direction_at(double cosine) { return {std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine}; }

double integrated(double cos_o, double alpha) {
  const math::Vec3d o = direction_at(cos_o);
  double sum = 0;
  over_visible(o, alpha, [&](const math::Vec3d& h, double weight) {
    const math::Vec3d back = h * (2 * math::dot(o, h)) - o;
    if (back.z > 0) sum += weight * ggx_also_visible(cos_o, back.z, alpha);
  });
  return sum;
}

double cosine_at(int i) {
  const double x = i / (cosine_nodes - 1.0);
  return std::max(1e-4, x * x);
}

// The trapezoidal rule for the mean with the weight 2 cos d(cos), cos = x^2.
double weight_at(int i) {
  const double x = i / (cosine_nodes - 1.0);
  return i == cosine_nodes - 1 ? x * x * x / 2 : x * x * x;
}

struct Table {
  std::array<std::array<double, cosine_nodes>, alpha_nodes> at;
  std::array<double, alpha_nodes> mean;

  Table() {
    for (int a = 0; a < alpha_nodes; ++a) {
      const double alpha = std::max(least_alpha, (a + 0.0) / (alpha_nodes - 1));
      double sum = 0, whole = 0;
      for (int i = 0; i < cosine_nodes; ++i) {
        const double value = integrated(cosine_at(i), alpha);
        at[static_cast<std::size_t>(a)][static_cast<std::size_t>(i)] = value;
        sum += value * weight_at(i), whole += weight_at(i);
      }
      mean[static_cast<std::size_t>(a)] = sum / whole;
    }
  }
};

const Table& table() {
  static const Table made;
  return made;
}

struct Between {
  std::size_t low, high;
  double share;
};

Between between(double x, int nodes) {
  const double inside = std::clamp(x, 0.0, nodes - 1.0);
  const auto low = static_cast<std::size_t>(std::min(std::floor(inside), nodes - 2.0));
  return {low, low + 1, inside - static_cast<double>(low)};
}

// The share of light refracted at the facet h that leaves on the far side, 0 for total reflection.
double leaves_behind(const math::Vec3d& o, const math::Vec3d& h, double alpha, double near_over_far) {
  const double o_h = math::dot(o, h), sin2 = near_over_far * near_over_far * (1 - o_h * o_h);
  if (sin2 >= 1) return 0;
  const double down = near_over_far * (h.z * o_h - o.z) - h.z * std::sqrt(1 - sin2);
  return down < 0 ? ggx_also_visible_behind(o.z, std::min(1.0, -down), alpha) : 0;
}

}  // namespace

FacetShares facet_shares(double cos_o, double alpha, double near_over_far) {
  const math::Vec3d o = direction_at(cos_o);
  const FacetCosines cosines(near_over_far);
  std::array<double, facet_nodes> seen{}, reflected{}, refracted{};
  over_visible(o, alpha, [&](const math::Vec3d& h, double weight) {
    const double o_h = std::clamp(math::dot(o, h), 0.0, 1.0), mirrored_z = 2 * o_h * h.z - o.z;
    const double lost_back = mirrored_z > 0 ? 1 - ggx_also_visible(cos_o, mirrored_z, alpha) : 1;
    const double lost_through = 1 - leaves_behind(o, h, alpha, near_over_far);
    const Between at = between(cosines.place(o_h), facet_nodes);
    const auto add = [&](std::array<double, facet_nodes>& to, double value) {
      to[at.low] += value * (1 - at.share), to[at.high] += value * at.share;
    };
    add(seen, weight), add(reflected, weight * lost_back), add(refracted, weight * lost_through);
  });
  FacetShares shares;
  for (std::size_t k = 0; k < facet_nodes; ++k) {
    shares.seen[k] = static_cast<float>(seen[k]);
    shares.lost_reflected[k] = static_cast<float>(reflected[k]);
    shares.lost_refracted[k] = static_cast<float>(refracted[k]);
  }
  return shares;
}

double single_scattering(double cos_o, double alpha) {
  const Between a = between(alpha * (alpha_nodes - 1), alpha_nodes);
  const Between c = between(std::sqrt(std::clamp(cos_o, 0.0, 1.0)) * (cosine_nodes - 1), cosine_nodes);
  const auto along = [&](const auto& row) { return row[c.low] + c.share * (row[c.high] - row[c.low]); };
  const double low = along(table().at[a.low]), high = along(table().at[a.high]);
  return low + a.share * (high - low);
}

double mean_single_scattering(double alpha) {
  const Between a = between(alpha * (alpha_nodes - 1), alpha_nodes);
  return table().mean[a.low] + a.share * (table().mean[a.high] - table().mean[a.low]);
}

}  // namespace shabon::render
