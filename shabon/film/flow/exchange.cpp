#include "shabon/film/flow/exchange.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shabon/base/random.h"
#include "shabon/film/flow/locate.h"
#include "shabon/math/normal_to.h"

namespace shabon::film {

namespace {

using math::Vec3d;
using std::numbers::pi;

constexpr double collapse_s = 0.1;  // in which film too thin to stand turns black
constexpr double rim_ratio = 2;     // a front runs on into its own rim up to so many times the nucleation thickness

// Towards the lowest point.
Vec3d downwards(const FlowDesc& desc) {
  const double g = math::length(desc.gravity_m_s2);
  return g > 0 ? desc.gravity_m_s2 * (1 / g) : Vec3d{0, -1, 0};
}

double floor_m(const FlowDesc& desc) {
  return desc.black_film ? std::max(thinnest_film_m, desc.black_film->thickness_nm * 1e-9) : thinnest_film_m;
}

// A direction whose angle from `axis` lies between the two.
Vec3d random_direction(Pcg32& random, const Vec3d& axis, double from_deg, double to_deg) {
  const double c = random.uniform(std::cos(to_deg * pi / 180), std::cos(from_deg * pi / 180));
  const double turn = random.uniform(0, 2 * pi), across = std::sqrt(std::max(0.0, 1 - c * c));
  const Vec3d x = math::any_normal_to(axis), y = math::cross(axis, x);
  return axis * c + x * (across * std::cos(turn)) + y * (across * std::sin(turn));
}

// A film element of the ratio's thickness instead of what was there.
void lay_patch(const Metric& metric, const RegenerationDesc& source, const Vec3d& centre, double least_m,
               FilmState& state) {
  constexpr double reach = 3.5;  // radii; exp(-12) is nothing
  const double per_radius = metric.radius / source.patch_radius_m,
               least_cos = std::cos(std::min(pi, reach / per_radius));
  for (std::size_t c = 0; c < state.thickness.size(); ++c) {
    const double cosine = math::dot(metric.grid->centres[c], centre);
    if (cosine < least_cos) continue;
    const double angle = std::acos(std::min(cosine, 1.0)) * per_radius;
    const double before = state.thickness[c];
    const double wanted = before * (1 - (1 - source.ratio) * std::exp(-angle * angle));
    const double after = std::max(wanted, std::min(before, least_m));
    state.thickness[c] = after;
    state.drop_m3 += (before - after) * metric.area[c];
  }
}

std::int64_t chances_until(const FlowDesc& desc, double end_s) {
  const double area_cm2 = 4 * pi * desc.radius_m * desc.radius_m * 1e4;
  return static_cast<std::int64_t>(std::ceil(desc.black_film->spots_per_s * area_cm2 * end_s));
}

// Chances of new black spots, the same at every level: the cell at the place of the event takes it.
void mark_spots(const Metric& metric, const FlowDesc& desc, double end_s, FilmState& state, std::vector<char>& chosen) {
  const std::uint64_t seed = hash64(desc.seed, 4);
  for (const std::int64_t last = chances_until(desc, end_s); state.spots < last; ++state.spots) {
    Pcg32 random(hash64(seed, static_cast<std::uint64_t>(state.spots)), 9);
    const Vec3d at = random_direction(random, {0, 0, 1}, 0, 180);
    chosen[nearest_cell(*metric.grid, at, 0)] = 1;
  }
}

}  // namespace

void evaporate(const Metric& metric, const FlowDesc& desc, double step_s, FilmState& state) {
  const Vec3d up = -downwards(desc);
  const double rate_m_s = desc.evaporation->rate_nm_s * 1e-9, excess = desc.evaporation->top_excess;
  const double least = floor_m(desc);
  Numbers lost = metric.grid->cell_numbers();
  for (std::size_t c = 0; c < lost.size(); ++c) {
    const double wanted = step_s * rate_m_s * (excess == 0 ? 1 : 1 + excess * math::dot(up, metric.grid->centres[c]));
    lost[c] = std::clamp(state.thickness[c] - least, 0.0, wanted);
    state.thickness[c] -= lost[c];
  }
  state.evaporated_m3 += integral(metric, lost);
}

void regenerate(const Metric& metric, const FlowDesc& desc, double end_s, FilmState& state) {
  const RegenerationDesc& source = *desc.regeneration;
  const std::uint64_t seed = hash64(desc.seed, 3);
  const auto time_of = [&](Pcg32& random) {
    return (static_cast<double>(state.patches) + random.uniform()) / source.rate_per_s;
  };
  while (source.rate_per_s > 0) {
    Pcg32 random(hash64(seed, static_cast<std::uint64_t>(state.patches)), 7);
    if (time_of(random) >= end_s) return;
    const Vec3d place = random_direction(random, downwards(desc), source.from_deg, source.to_deg);
    lay_patch(metric, source, place, floor_m(desc), state);
    ++state.patches;
  }
}

void collapse(const Metric& metric, const FlowDesc& desc, double end_s, double step_s, FilmState& state) {
  const BlackFilmDesc& black = *desc.black_film;
  const auto& h = state.thickness;
  const std::size_t cells = h.size();
  const double rest = black.thickness_nm * 1e-9, nucleation = black.nucleation_nm * 1e-9;
  const auto all = h.values();
  std::vector<char> chosen(cells, 0);
  if (!(*std::min_element(all.begin(), all.end()) < nucleation)) {
    state.spots = chances_until(desc, end_s);
    return;
  }
  mark_spots(metric, desc, end_s, state, chosen);
  // What each cell gives away, and to how many: to neighbours that are not black and no thinner than itself.
  const double grows = 1 - std::exp(-step_s * black.front_m_s / metric.least_distance);
  const double falls = 1 - std::exp(-step_s / collapse_s), unstable = (rest + nucleation) / 2;
  const double rim = rim_ratio * nucleation;
  std::vector<double> given(cells, 0.0);
  const auto takes = [&](double giver, double taker) { return taker >= giver && !is_black(black, taker); };
  for (std::size_t c = 0; c < cells; ++c) {
    if (!(h[c] < rim && h[c] > rest)) continue;
    const CellAround around = metric.topology().around(static_cast<Index>(c));
    bool beside_black = false;
    double takers = 0;
    for (std::size_t k = 0; k < slots; ++k) {
      if (around.sign[k] == 0) continue;
      const double there = h[static_cast<std::size_t>(around.cell[k])];
      beside_black = beside_black || is_black(black, there);
      takers += takes(h[c], there) ? 1 : 0;
    }
    if (takers == 0) continue;
    const double share = std::max(
        {chosen[c] && h[c] < nucleation ? 1.0 : 0.0, beside_black ? grows : 0.0, h[c] < unstable ? falls : 0.0});
    given[c] = (h[c] - rest) * metric.area[c] * share / takers;
  }
  Numbers next = h;
  for (std::size_t c = 0; c < cells; ++c) {
    const CellAround around = metric.topology().around(static_cast<Index>(c));
    double change = 0;
    for (std::size_t k = 0; k < slots; ++k) {
      const auto n = static_cast<std::size_t>(around.cell[k]);
      if (around.sign[k] == 0) continue;
      if (given[c] > 0 && takes(h[c], h[n])) change -= given[c];
      if (given[n] > 0 && takes(h[n], h[c])) change += given[n];
    }
    next[c] = h[c] + change * metric.per_area[c];
  }
  state.thickness = std::move(next);
}

void break_if_thin(const Metric& metric, const FlowDesc& desc, double end_s, FilmState& state) {
  const RuptureDesc& rupture = *desc.rupture;
  const double threshold_nm = rupture.from_nm + (rupture.to_nm - rupture.from_nm) * unit_double(hash64(desc.seed, 6));
  const auto all = state.thickness.values();
  const auto thinnest = std::min_element(all.begin(), all.end());
  if (!(*thinnest * 1e9 < threshold_nm)) return;
  const auto cell = static_cast<std::size_t>(thinnest - all.begin());
  state.rupture = FilmFlow::Rupture{end_s, threshold_nm, metric.grid->centres[cell]};
}

}  // namespace shabon::film
