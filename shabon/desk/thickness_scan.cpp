#include "shabon/desk/thickness_scan.h"

#include <algorithm>
#include <cmath>

namespace shabon::desk {

namespace {

constexpr int parts = 8;        // of a bracket, each time it is narrowed
constexpr int narrowings = 12;  // each to a quarter: 1 nm becomes 1e-7 nm
constexpr int halvings = 24;    // on the way to the ends of a valley
constexpr double deepest = 36;  // misfit above the minimum where a valley ends: e^-18 of the probability
// Places of a valley at which it is integrated: evenly, and on each side ever closer towards the minimum.
constexpr int even_parts = 128, side_parts = 48;
constexpr int interval_tries = 256;
// A stretch that is told as level takes up so much of the interval and of the range.
constexpr double least_level_share = 0.95, least_range_share = 0.1;
// The minimum of a level stretch counts where it is lower than the stretch's middle by this.
constexpr double noticed_misfit = 1e-3;

// A minimum with the part of the range that belongs to it.
struct Valley {
  ScanMinimum minimum;
  double left_nm, right_nm;  // the bracket of the minimum
  double low_nm, high_nm;    // the highest places on both sides
  double low_misfit, high_misfit;
};

std::vector<double> grid_of(const ScanRange& range) {
  const double steps = std::ceil((range.high_nm - range.low_nm) / range.step_nm);
  const auto count = static_cast<std::size_t>(std::max(steps, 2.0));
  std::vector<double> grid;
  for (std::size_t i = 0; i <= count; ++i)
    grid.push_back(range.low_nm + (range.high_nm - range.low_nm) * static_cast<double>(i) / static_cast<double>(count));
  return grid;
}

std::vector<Valley> valleys_of(const std::vector<double>& grid, const std::vector<double>& misfits) {
  const std::size_t last = grid.size() - 1;
  std::vector<std::size_t> minima;
  for (std::size_t i = 0; i <= last; ++i)
    if ((i == 0 || misfits[i] <= misfits[i - 1]) && (i == last || misfits[i] < misfits[i + 1])) minima.push_back(i);
  const auto highest = [&](std::size_t first, std::size_t end) {
    const auto begin = misfits.begin();
    return static_cast<std::size_t>(
        std::max_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end) + 1) -
        begin);
  };
  std::vector<Valley> valleys;
  for (std::size_t m = 0; m < minima.size(); ++m) {
    const std::size_t at = minima[m];
    const std::size_t low = highest(m == 0 ? 0 : minima[m - 1], at);
    const std::size_t high = highest(at, m + 1 == minima.size() ? last : minima[m + 1]);
    Valley valley{
        {},           grid[at == 0 ? 0 : at - 1], grid[std::min(at + 1, last)], grid[low], grid[high], misfits[low],
        misfits[high]};
    valley.minimum.thickness_nm = grid[at], valley.minimum.misfit = misfits[at];
    valleys.push_back(valley);
  }
  return valleys;
}

// Valleys that hardly a crest parts become one: a level stretch has as many minima as rounding makes.
std::vector<Valley> merged(const std::vector<Valley>& valleys) {
  std::vector<Valley> kept;
  for (const Valley& next : valleys) {
    if (kept.empty() || next.low_misfit - std::max(kept.back().minimum.misfit, next.minimum.misfit) >= crest_misfit) {
      kept.push_back(next);
      continue;
    }
    Valley& last = kept.back();
    if (next.minimum.misfit < last.minimum.misfit)
      last.minimum = next.minimum, last.left_nm = next.left_nm, last.right_nm = next.right_nm;
    last.high_nm = next.high_nm, last.high_misfit = next.high_misfit;
  }
  return kept;
}

// All brackets at once: the function is cheaper for many thicknesses together.
void narrow(std::vector<Valley>& valleys, const Misfit& misfit) {
  for (int step = 0; step < narrowings; ++step) {
    std::vector<double> at;
    for (const Valley& v : valleys)
      for (int i = 0; i <= parts; ++i) at.push_back(v.left_nm + (v.right_nm - v.left_nm) * i / parts);
    const std::vector<double> misfits = misfit(at);
    for (std::size_t v = 0; v < valleys.size(); ++v) {
      const std::size_t first = v * (parts + 1), last = first + parts;
      std::size_t best = first;
      for (std::size_t i = first; i <= last; ++i)
        if (misfits[i] < misfits[best]) best = i;
      valleys[v].left_nm = at[best == first ? best : best - 1],
      valleys[v].right_nm = at[best == last ? best : best + 1];
      if (misfits[best] <= valleys[v].minimum.misfit)
        valleys[v].minimum.thickness_nm = at[best], valleys[v].minimum.misfit = misfits[best];
    }
  }
}

// Draws the ends of each valley in to where the probability has become nothing.
void trim_sides(std::vector<Valley>& valleys, const Misfit& misfit) {
  std::vector<double> inner_low, inner_high;
  for (const Valley& v : valleys)
    inner_low.push_back(v.minimum.thickness_nm), inner_high.push_back(v.minimum.thickness_nm);
  for (int step = 0; step < halvings; ++step) {
    std::vector<double> at;
    for (std::size_t i = 0; i < valleys.size(); ++i)
      at.push_back((valleys[i].low_nm + inner_low[i]) / 2), at.push_back((valleys[i].high_nm + inner_high[i]) / 2);
    const std::vector<double> misfits = misfit(at);
    for (std::size_t i = 0; i < valleys.size(); ++i) {
      Valley& v = valleys[i];
      const double most = v.minimum.misfit + deepest;
      if (v.low_misfit > most) (misfits[2 * i] > most ? v.low_nm : inner_low[i]) = at[2 * i];
      if (v.high_misfit > most) (misfits[2 * i + 1] > most ? v.high_nm : inner_high[i]) = at[2 * i + 1];
    }
  }
}

std::vector<double> places_of(const Valley& v) {
  const double at_nm = v.minimum.thickness_nm;
  std::vector<double> places{at_nm};
  for (int i = 0; i <= even_parts; ++i) places.push_back(v.low_nm + (v.high_nm - v.low_nm) * i / even_parts);
  for (int i = 1; i < side_parts; ++i) {
    const double share = std::pow(static_cast<double>(i) / side_parts, 3);
    places.push_back(at_nm + (v.low_nm - at_nm) * share), places.push_back(at_nm + (v.high_nm - at_nm) * share);
  }
  std::sort(places.begin(), places.end());
  return places;
}

// A valley's probability along its places, linear from one to the next; 1 at the minimum.
class Probability {
 public:
  Probability(const std::vector<double>& at, const double* misfits, double least) : at_(at), sums_{0} {
    for (std::size_t i = 0; i < at.size(); ++i) {
      densities_.push_back(std::exp((least - misfits[i]) / 2));
      if (i > 0) sums_.push_back(sums_.back() + (densities_[i - 1] + densities_[i]) / 2 * (at[i] - at[i - 1]));
    }
  }

  double sum() const { return sums_.back(); }
  double place(double share) const {
    const double sum = share * sums_.back();
    const auto next = static_cast<std::size_t>(std::lower_bound(sums_.begin(), sums_.end(), sum) - sums_.begin());
    if (next == 0 || next == at_.size() || !(sums_[next] > sums_[next - 1])) return at_[std::min(next, at_.size() - 1)];
    const double width_nm = at_[next] - at_[next - 1], rest = sum - sums_[next - 1];
    const double below = densities_[next - 1], slope = (densities_[next] - below) / width_nm;
    const double root = std::sqrt(std::max(below * below + 2 * slope * rest, 0.0));
    return std::min(at_[next], at_[next - 1] + 2 * rest / (below + root));
  }

  // The shortest interval that holds 95 % and this place.
  Stretch interval(double held_nm) const {
    Stretch shortest{at_.front(), at_.back()};
    for (int i = 0; i <= interval_tries; ++i) {
      const double below = (1 - credible_share) * i / interval_tries;
      const Stretch tried{std::min(place(below), held_nm), std::max(place(below + credible_share), held_nm)};
      if (tried.high_nm - tried.low_nm < shortest.high_nm - shortest.low_nm) shortest = tried;
    }
    return shortest;
  }

 private:
  const std::vector<double>& at_;
  std::vector<double> densities_, sums_;
};

// The places around the minimum where the misfit is as low.
Stretch level_stretch(const Valley& v, const std::vector<double>& at, const double* misfits) {
  const double most = v.minimum.misfit + level_misfit;
  const auto centre =
      static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), v.minimum.thickness_nm) - at.begin());
  const auto end = [&](std::size_t inside, std::size_t outside) {  // between two places
    return at[inside] + (at[outside] - at[inside]) * (most - misfits[inside]) / (misfits[outside] - misfits[inside]);
  };
  std::size_t low = centre, high = centre;
  while (low > 0 && misfits[low - 1] <= most) --low;
  while (high + 1 < at.size() && misfits[high + 1] <= most) ++high;
  return {low == 0 ? at.front() : end(low, low - 1), high + 1 == at.size() ? at.back() : end(high, high + 1)};
}

void weigh(Valley& v, const std::vector<double>& at, const double* misfits, double least, double wide_nm) {
  const Probability probability(at, misfits, v.minimum.misfit);
  v.minimum.weight = probability.sum() * std::exp((least - v.minimum.misfit) / 2);
  const Stretch interval = probability.interval(v.minimum.thickness_nm);
  v.minimum.interval_low_nm = interval.low_nm, v.minimum.interval_high_nm = interval.high_nm;
  const Stretch level = level_stretch(v, at, misfits);
  const double width_nm = level.high_nm - level.low_nm;
  if (width_nm > least_level_share * (interval.high_nm - interval.low_nm) && width_nm >= wide_nm)
    v.minimum.level = level;
}

// What the scan itself says of a valley's probability: enough for those that are left out.
double rough_weight(const Valley& v, const std::vector<double>& grid, const std::vector<double>& misfits,
                    double least) {
  double sum = 0;
  for (std::size_t i = 1; i < grid.size(); ++i)
    if (grid[i - 1] >= v.low_nm && grid[i] <= v.high_nm)
      sum +=
          (std::exp((least - misfits[i - 1]) / 2) + std::exp((least - misfits[i]) / 2)) / 2 * (grid[i] - grid[i - 1]);
  return sum;
}

// `left_out` is the probability of what is in none of the valleys, with exp(-least/2) for the unit.
void weigh_all(std::vector<Valley>& valleys, const Misfit& misfit, double least, double left_out, double wide_nm) {
  std::vector<std::vector<double>> places;
  std::vector<double> all;
  for (const Valley& v : valleys) {
    places.push_back(places_of(v));
    all.insert(all.end(), places.back().begin(), places.back().end());
  }
  const std::vector<double> misfits = misfit(all);
  double sum = left_out;
  for (std::size_t i = 0, first = 0; i < valleys.size(); first += places[i++].size()) {
    weigh(valleys[i], places[i], &misfits[first], least, wide_nm);
    sum += valleys[i].minimum.weight;
  }
  for (Valley& v : valleys) v.minimum.weight /= sum;
}

// A level stretch is told by its middle, which no rounding moves.
void centre_levels(std::vector<Valley>& valleys, const Misfit& misfit) {
  std::vector<double> middles;
  for (const Valley& v : valleys)
    middles.push_back(v.minimum.level ? (v.minimum.level->low_nm + v.minimum.level->high_nm) / 2
                                      : v.minimum.thickness_nm);
  const std::vector<double> misfits = misfit(middles);
  for (std::size_t i = 0; i < valleys.size(); ++i) {
    ScanMinimum& minimum = valleys[i].minimum;
    if (!minimum.level || misfits[i] > minimum.misfit + noticed_misfit) continue;
    minimum.thickness_nm = middles[i], minimum.misfit = misfits[i];
    minimum.interval_low_nm = std::min(minimum.interval_low_nm, middles[i]);
    minimum.interval_high_nm = std::max(minimum.interval_high_nm, middles[i]);
  }
}

}  // namespace

std::vector<ScanMinimum> scanned_minima(const Misfit& misfit, const ScanRange& range, std::size_t most) {
  const std::vector<double> grid = grid_of(range), misfits = misfit(grid);
  std::vector<Valley> valleys = merged(valleys_of(grid, misfits));
  const auto lower = [](const Valley& a, const Valley& b) { return a.minimum.misfit < b.minimum.misfit; };
  std::stable_sort(valleys.begin(), valleys.end(), lower);
  const double least = valleys.front().minimum.misfit;
  double left_out = 0;
  for (; valleys.size() > most; valleys.pop_back()) left_out += rough_weight(valleys.back(), grid, misfits, least);
  narrow(valleys, misfit);
  trim_sides(valleys, misfit);
  weigh_all(valleys, misfit, least, left_out, least_range_share * (range.high_nm - range.low_nm));
  centre_levels(valleys, misfit);
  std::stable_sort(valleys.begin(), valleys.end(), lower);
  std::vector<ScanMinimum> minima;
  for (Valley& v : valleys) {
    v.minimum.at_end = v.minimum.thickness_nm <= range.low_nm || v.minimum.thickness_nm >= range.high_nm;
    minima.push_back(v.minimum);
  }
  return minima;
}

std::size_t count_credible(std::vector<double> weights) {
  std::sort(weights.begin(), weights.end(), std::greater<>());
  double held = 0;
  std::size_t count = 0;
  while (count < weights.size() && held < credible_share) held += weights[count++];
  return count;
}

}  // namespace shabon::desk
