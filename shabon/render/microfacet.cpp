#include "shabon/render/microfacet.h"

#include <array>

namespace shabon::render {

namespace {

// Nodes over the cosine (at squares, denser towards grazing) and over alpha.
constexpr int cosine_nodes = 32, alpha_nodes = 32;
constexpr int points_across = 32;  // the integral over visible normals takes the square of this many points

double integrated(double cos_o, double alpha) {
  const math::Vec3d o{std::sqrt(std::max(0.0, 1 - cos_o * cos_o)), 0, cos_o};
  double sum = 0;
  for (int i = 0; i < points_across; ++i)
    for (int j = 0; j < points_across; ++j) {
      const math::Vec3d h = ggx_sample_visible(o, alpha, (i + 0.5) / points_across, (j + 0.5) / points_across);
      const math::Vec3d back = h * (2 * math::dot(o, h)) - o;
      if (back.z > 0) sum += ggx_also_visible(cos_o, back.z, alpha);
    }
  return sum / (points_across * points_across);
}

double cosine_at(int i) {
  const double x = (i + 0.5) / cosine_nodes;
  return x * x;
}

struct Table {
  std::array<std::array<double, cosine_nodes>, alpha_nodes> at;
  std::array<double, alpha_nodes> mean;

  Table() {
    for (int a = 0; a < alpha_nodes; ++a) {
      const double alpha = std::max(least_alpha, (a + 0.0) / (alpha_nodes - 1));
      double sum = 0;
      for (int i = 0; i < cosine_nodes; ++i) {
        const double x = (i + 0.5) / cosine_nodes, cosine = cosine_at(i);
        const double value = integrated(cosine, alpha);
        at[static_cast<std::size_t>(a)][static_cast<std::size_t>(i)] = value;
        sum += value * 2 * cosine * 2 * x / cosine_nodes;  // 2 cos d(cos), cos = x^2
      }
      double whole = 0;
      for (int i = 0; i < cosine_nodes; ++i) whole += 2 * cosine_at(i) * 2 * (i + 0.5) / cosine_nodes / cosine_nodes;
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

}  // namespace

double single_scattering(double cos_o, double alpha) {
  const Between a = between(alpha * (alpha_nodes - 1), alpha_nodes);
  const Between c = between(std::sqrt(std::clamp(cos_o, 0.0, 1.0)) * cosine_nodes - 0.5, cosine_nodes);
  const auto along = [&](const auto& row) { return row[c.low] + c.share * (row[c.high] - row[c.low]); };
  const double low = along(table().at[a.low]), high = along(table().at[a.high]);
  return low + a.share * (high - low);
}

double mean_single_scattering(double alpha) {
  const Between a = between(alpha * (alpha_nodes - 1), alpha_nodes);
  return table().mean[a.low] + a.share * (table().mean[a.high] - table().mean[a.low]);
}

}  // namespace shabon::render
