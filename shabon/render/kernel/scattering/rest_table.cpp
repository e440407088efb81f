#include "shabon/render/kernel/scattering/rest_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/base/parallel.h"
#include "shabon/render/kernel/scattering/facet_powers.h"
#include "shabon/render/microfacet.h"

namespace shabon::render {
inline namespace SHABON_REGISTERS {

namespace {

constexpr double least_cosine = 1e-4;  // nothing is seen at a smaller angle to the surface

struct Place {
  std::size_t low, high;
  float share;  // of high
};

Place place_among(double x, int count) {
  if (count < 2) return {0, 0, 0};
  const double inside = std::clamp(x, 0.0, count - 1.0);
  const auto low = static_cast<std::size_t>(std::min(inside, count - 2.0));
  return {low, low + 1, static_cast<float>(inside - static_cast<double>(low))};
}

Place place_in(const Nodes& nodes, double value) {
  const double length = nodes.last - nodes.first;
  return place_among(length > 0 ? (value - nodes.first) / length * (nodes.count - 1) : 0, nodes.count);
}

// Of the hat functions over the cosines x^2, x = i/(count-1), each one's share of a diffuse field: the integral of
// 2 cos d(cos) = 4 x^3 dx.
std::vector<float> diffuse_weights(int count) {
  std::vector<double> weights(static_cast<std::size_t>(count));
  for (int i = 0; i + 1 < count; ++i) {
    const double a = i / (count - 1.0), b = (i + 1) / (count - 1.0);
    const double whole = std::pow(b, 4) - std::pow(a, 4), first = 0.8 * (std::pow(b, 5) - std::pow(a, 5));
    const double high = (first - a * whole) / (b - a);
    weights[static_cast<std::size_t>(i)] += whole - high, weights[static_cast<std::size_t>(i) + 1] += high;
  }
  return {weights.begin(), weights.end()};
}

float mean_of(const Lanes& lanes) { return math::sum(lanes) * (1.0f / lane_count); }

double fourth_power_at(std::size_t node, int count) { return std::pow(static_cast<double>(node) / (count - 1), 4); }

struct Scattered {
  Lanes seen_reflected{0.0f}, seen_transmitted{0.0f}, lost_reflected{0.0f}, lost_refracted{0.0f};
};

Scattered sums(const FacetShares& shares, const Lanes* R, const Lanes* T) {
  Scattered sum;
  for (std::size_t k = 0; k < facet_nodes; ++k) {
    sum.seen_reflected += R[k] * Lanes(shares.seen[k]);
    sum.seen_transmitted += T[k] * Lanes(shares.seen[k]);
    sum.lost_reflected += R[k] * Lanes(shares.lost_reflected[k]);
    sum.lost_refracted += T[k] * Lanes(shares.lost_refracted[k]);
  }
  return sum;
}

}  // namespace

// [(ratio * alphas + alpha) * cosines + cosine]; the mean ratio comes first, then, where wavelengths differ, evenly
// spaced ones from the least to the most.
struct RestTable::Shares {
  std::vector<FacetShares> shares;
  Nodes ratio;
  std::size_t rows = 0;  // of one ratio

  explicit Shares(const Side& side) : ratio(ratios_of(side)) {
    const auto alphas = static_cast<std::size_t>(side.alpha.count), cosines = static_cast<std::size_t>(cosine_nodes);
    rows = alphas * cosines;
    shares.resize(rows * (1 + static_cast<std::size_t>(ratio.count)));
    parallel_for(shares.size(), 0, [&](std::size_t i) {
      const double x = static_cast<double>(i % cosines) / (cosine_nodes - 1);
      const auto node = static_cast<int>(i / rows);
      shares[i] = facet_shares(std::max(least_cosine, x * x), side.alpha.at(static_cast<int>(i % rows / cosines)),
                               node == 0 ? side.near_over_far : ratio.at(node - 1));
    });
  }

  // No nodes where all wavelengths are bent alike, or some towards the normal and some away from it: hardly at all.
  static Nodes ratios_of(const Side& side) {
    constexpr int nodes = 3;  // glasses spread over a few per cent
    double least = side.near_over_far, most = side.near_over_far;
    for (const LanesD& row : side.each_near_over_far)
      for (int i = 0; i < lane_count; ++i) least = std::min(least, row[i]), most = std::max(most, row[i]);
    if (!side.refracts || most - least < 1e-6 * most || (least <= 1 && most > 1)) return {};
    return {least, most, nodes};
  }
};

RestTable::RestTable(const Side& side)
    : alpha_(side.alpha),
      thickness_nm_(side.thickness_nm),
      near_over_far_(side.near_over_far),
      chooses_(side.refracts && side.near_over_far > 1),
      combs_(side.combs) {
  const auto alphas = static_cast<std::size_t>(alpha_.count), cosines = static_cast<std::size_t>(cosine_nodes);
  const Shares shares(side);
  const auto thicknesses = static_cast<std::size_t>(thickness_nm_.count);
  rest_.resize(thicknesses * alphas * combs_ * cosines);
  means_.resize(thicknesses * alphas * combs_);
  once_.resize(rest_.size());
  facets_.resize(thicknesses * facet_nodes * combs_);
  parallel_for(thicknesses * combs_, 0, [&](std::size_t i) { fill(side, shares, i / combs_, i % combs_); });
  over_wavelengths_.resize(thicknesses * alphas);
  for (std::size_t node = 0; node < over_wavelengths_.size(); ++node) fill_means(node);
  once_.clear(), once_.shrink_to_fit();
  for (std::size_t i = 0; i < thicknesses * facet_nodes; ++i) {
    float sum = 0;
    for (std::size_t comb = 0; comb < combs_; ++comb) sum += facets_[i * combs_ + comb];
    facets_[i] = sum / static_cast<float>(combs_);
  }
  facets_.resize(thicknesses * facet_nodes);
}

namespace {

// How much each wavelength takes of what is known at a node of the ratio of the indices.
Lanes share_of_node(const Nodes& nodes, int node, const LanesD& ratios) {
  alignas(64) float shares[lane_count];
  for (int i = 0; i < lane_count; ++i) {
    const double place = (ratios[i] - nodes.first) / (nodes.last - nodes.first) * (nodes.count - 1);
    shares[i] = static_cast<float>(std::max(0.0, 1 - std::abs(place - node)));
  }
  return Lanes::load(shares);
}

}  // namespace

// (61) and (62): what the film absorbs, or lets through, of light that meets further facets is taken from its means.
void RestTable::fill(const Side& side, const Shares& shares, std::size_t thickness, std::size_t comb) {
  static const std::vector<float> over_rest = diffuse_weights(cosine_nodes);
  const double nm = thickness_nm_.at(static_cast<int>(thickness));
  const FacetPowers all = powers_at(side, FacetCosines(side.near_over_far), comb, nm);
  for (std::size_t k = 0; k < facet_nodes; ++k)
    facets_[(thickness * facet_nodes + k) * combs_ + comb] = mean_of(all.R[k]);
  const bool differ = shares.ratio.count > 0;
  const FacetPowers own = differ ? powers_at_own(side, comb, nm) : all;
  const Lanes absorbed = max(Lanes(1.0f) - own.R_mean - own.T_mean, Lanes(0.0f));
  const Lanes kept = min(own.R_mean + own.T_mean, Lanes(1.0f));
  const Lanes passed = own.T_mean / max(own.T_mean + absorbed, Lanes(1e-20f));
  for (std::size_t a = 0; a < static_cast<std::size_t>(alpha_.count); ++a) {
    const std::size_t first = row(thickness, a, comb) * cosine_nodes;
    Lanes* rest = &rest_[first];
    for (std::size_t c = 0; c < cosine_nodes; ++c) {
      const std::size_t place = a * cosine_nodes + c;
      const Scattered sum = sums(shares.shares[place], all.R, all.T);
      rest[c] = side.refracts ? kept * (sum.lost_reflected + sum.lost_refracted)
                              : sum.seen_transmitted + passed * sum.lost_reflected;
      once_[first + c] = {mean_of(sum.seen_reflected - sum.lost_reflected),
                          mean_of(sum.seen_transmitted - sum.lost_refracted), mean_of(sum.seen_reflected)};
      if (!differ) continue;
      rest[c] = Lanes(0.0f);
      for (int node = 0; node < shares.ratio.count; ++node) {
        const FacetShares& at_node = shares.shares[(static_cast<std::size_t>(node) + 1) * shares.rows + place];
        const Scattered of_node = sums(at_node, own.R, own.T);
        rest[c] += share_of_node(shares.ratio, node, side.each_near_over_far[comb]) * kept *
                   (of_node.lost_reflected + of_node.lost_refracted);
      }
    }
    means_[row(thickness, a, comb)] = weighted(over_rest, rest);
  }
}

void RestTable::fill_means(std::size_t node) {
  Means& means = over_wavelengths_[node];
  float rest[cosine_nodes] = {};
  for (std::size_t comb = 0; comb < combs_; ++comb)
    for (std::size_t c = 0; c < cosine_nodes; ++c) {
      const std::size_t i = (node * combs_ + comb) * cosine_nodes + c;
      const float weight = 1 / static_cast<float>(combs_);
      rest[c] += weight * mean_of(rest_[i]);
      means.once[c].mirrored += weight * once_[i].mirrored, means.once[c].refracted += weight * once_[i].refracted;
      means.once[c].reflectance += weight * once_[i].reflectance;
    }
  constexpr double even = 0.1;  // single wavelengths may ask for light where the mean does not
  double sum = 0, shares[cosine_nodes] = {};
  for (std::size_t c = 0; c + 1 < cosine_nodes; ++c) {
    shares[c] = (fourth_power_at(c + 1, cosine_nodes) - fourth_power_at(c, cosine_nodes)) * (rest[c] + rest[c + 1]);
    sum += shares[c];
  }
  double below = 0;
  for (std::size_t c = 0; c < cosine_nodes; ++c) {
    const double evenly = fourth_power_at(c, cosine_nodes);
    means.below[c] = static_cast<float>(sum > 0 ? even * evenly + (1 - even) * below / sum : evenly);
    below += shares[c];
  }
  means.below[cosine_nodes - 1] = 1;
}

std::size_t RestTable::row(std::size_t thickness, std::size_t alpha, std::size_t comb) const {
  return (thickness * static_cast<std::size_t>(alpha_.count) + alpha) * combs_ + comb;
}

// read(row) between the rows next to this roughness and thickness.
template <class Read>
auto RestTable::between_rows(std::size_t comb, double alpha, double thickness_nm, const Read& read) const {
  using Value = decltype(read(std::size_t{}));
  const Place a = place_in(alpha_, alpha), t = place_in(thickness_nm_, thickness_nm);
  const auto along_alpha = [&](std::size_t thickness) {
    const Value low = read(row(thickness, a.low, comb));
    return a.share > 0 ? low + Value(a.share) * (read(row(thickness, a.high, comb)) - low) : low;
  };
  const Value low = along_alpha(t.low);
  return t.share > 0 ? low + Value(t.share) * (along_alpha(t.high) - low) : low;
}

Lanes RestTable::at(std::size_t comb, double cos, double alpha, double thickness_nm) const {
  const Place c = place_among(std::sqrt(std::clamp(cos, 0.0, 1.0)) * (cosine_nodes - 1), cosine_nodes);
  return between_rows(comb, alpha, thickness_nm, [&](std::size_t r) {
    const Lanes* rest = &rest_[r * cosine_nodes];
    return rest[c.low] + Lanes(c.share) * (rest[c.high] - rest[c.low]);
  });
}

Lanes RestTable::mean(std::size_t comb, double alpha, double thickness_nm) const {
  return between_rows(comb, alpha, thickness_nm, [&](std::size_t r) { return means_[r]; });
}

const RestTable::Means& RestTable::means_near(double alpha, double thickness_nm) const {
  const auto nearest = [](const Place& place) { return place.share < 0.5f ? place.low : place.high; };
  const std::size_t t = nearest(place_in(thickness_nm_, thickness_nm)), a = nearest(place_in(alpha_, alpha));
  return over_wavelengths_[t * static_cast<std::size_t>(alpha_.count) + a];
}

RestTable::Once RestTable::once(double cos, double alpha, double thickness_nm) const {
  const Place c = place_among(std::sqrt(std::clamp(cos, 0.0, 1.0)) * (cosine_nodes - 1), cosine_nodes);
  const auto number = [&](float Once::*which) {
    return between_rows(0, alpha, thickness_nm, [&](std::size_t r) {
      const Once* once = over_wavelengths_[r / combs_].once;
      return once[c.low].*which + c.share * (once[c.high].*which - once[c.low].*which);
    });
  };
  return {number(&Once::mirrored), number(&Once::refracted), number(&Once::reflectance)};
}

namespace {

// Some facets are chosen of every kind: wavelengths differ. Facets that are nearly one plane need no choice, and the
// mean over them is then less exact.
double willing(bool refract, double reflectance, double alpha) {
  const double strength = 0.9 * std::pow(std::min(1.0, alpha / 0.1), 2);
  return 1 - strength + strength * (refract ? 1 - reflectance : reflectance);
}

}  // namespace

double RestTable::choice(bool refract, double cos, double alpha, double thickness_nm) const {
  if (!chooses_) return 1;
  const Place t = place_in(thickness_nm_, thickness_nm);
  const Place c = place_among(FacetCosines(near_over_far_).place(std::clamp(cos, 0.0, 1.0)), facet_nodes);
  const auto at = [&](std::size_t thickness) {
    const float* row = &facets_[thickness * facet_nodes];
    return double(row[c.low]) + double(c.share) * (double(row[c.high]) - double(row[c.low]));
  };
  return willing(refract, at(t.low) + double(t.share) * (at(t.high) - at(t.low)), alpha);
}

double RestTable::mean_choice(bool refract, double cos_o, double alpha, double thickness_nm) const {
  return chooses_ ? willing(refract, double(once(cos_o, alpha, thickness_nm).reflectance), alpha) : 1;
}

// Between two nodes as often as a diffuse field asks for.
double RestTable::sample_cosine(double u, double alpha, double thickness_nm) const {
  const Means& means = means_near(alpha, thickness_nm);
  std::size_t c = 0;
  while (c + 2 < cosine_nodes && means.below[c + 1] <= u) ++c;
  const double share = (u - means.below[c]) / std::max(1e-12, double(means.below[c + 1]) - double(means.below[c]));
  const double low = fourth_power_at(c, cosine_nodes), high = fourth_power_at(c + 1, cosine_nodes);
  return std::sqrt(low + std::clamp(share, 0.0, 1.0) * (high - low));
}

double RestTable::density(double cos, double alpha, double thickness_nm) const {
  if (cos <= 0) return 0;
  const Means& means = means_near(alpha, thickness_nm);
  const std::size_t c = place_among(std::sqrt(std::min(1.0, cos)) * (cosine_nodes - 1), cosine_nodes).low;
  const double low = fourth_power_at(c, cosine_nodes), high = fourth_power_at(c + 1, cosine_nodes);
  return (double(means.below[c + 1]) - double(means.below[c])) * cos / (std::numbers::pi * (high - low));
}

}  // namespace SHABON_REGISTERS
}  // namespace shabon::render
