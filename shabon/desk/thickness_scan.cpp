#include "shabon/desk/thickness_scan.h"

#include <algorithm>
#include <cmath>

namespace shabon::desk {

namespace {

constexpr int parts = 8;        // of a bracket, each time it is narrowed
constexpr int narrowings = 12;  // each to a quarter: 1 nm becomes 1e-7 nm
constexpr int halvings = 24;    // on the way to the ends of a valley
constexpr double deepest = 36;  // misfit above the minimum where a valley ends: e^-18 of the probability
constexpr int interval_parts = 128;

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

// Trapezia: `sums` is the probability up to each place, with exp(-least/2) for the unit.
void weigh(Valley& v, const std::vector<double>& at, const double* misfits, double least) {
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < at.size(); ++i) {
    const double below = std::exp((least - misfits[i - 1]) / 2), here = std::exp((least - misfits[i]) / 2);
    sums.push_back(sums.back() + (below + here) / 2 * (at[i] - at[i - 1]));
  }
  v.minimum.weight = sums.back();
  const auto place = [&](double share) {
    const double sum = share * sums.back();
    const auto next = static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), sum) - sums.begin());
    if (next == 0 || !(sums[next] > sums[next - 1])) return at[std::min(next, at.size() - 1)];
    return at[next - 1] + (at[next] - at[next - 1]) * (sum - sums[next - 1]) / (sums[next] - sums[next - 1]);
  };
  // At an end of the range all that is left out lies on the other side.
  const bool at_low = v.minimum.thickness_nm <= at.front(), at_high = v.minimum.thickness_nm >= at.back();
  const double tail = at_low || at_high ? 1 - credible_share : (1 - credible_share) / 2;
  if (!(sums.back() > 0)) return void(v.minimum.interval_low_nm = v.minimum.interval_high_nm = v.minimum.thickness_nm);
  v.minimum.interval_low_nm = at_low ? at.front() : place(tail);
  v.minimum.interval_high_nm = at_high ? at.back() : place(1 - tail);
}

void weigh_all(std::vector<Valley>& valleys, const Misfit& misfit) {
  double least = valleys.front().minimum.misfit, sum = 0;
  for (const Valley& v : valleys) least = std::min(least, v.minimum.misfit);
  std::vector<std::vector<double>> places;
  std::vector<double> all;
  for (const Valley& v : valleys) {
    std::vector<double> at;
    for (int i = 0; i <= interval_parts; ++i) at.push_back(v.low_nm + (v.high_nm - v.low_nm) * i / interval_parts);
    all.insert(all.end(), at.begin(), at.end());
    places.push_back(std::move(at));
  }
  const std::vector<double> misfits = misfit(all);
  for (std::size_t i = 0; i < valleys.size(); ++i) {
    weigh(valleys[i], places[i], &misfits[i * (interval_parts + 1)], least);
    sum += valleys[i].minimum.weight;
  }
  for (Valley& v : valleys) v.minimum.weight /= sum;
}

}  // namespace

std::vector<ScanMinimum> scanned_minima(const Misfit& misfit, const ScanRange& range, std::size_t most) {
  const std::vector<double> grid = grid_of(range);
  std::vector<Valley> valleys = valleys_of(grid, misfit(grid));
  const auto lower = [](const Valley& a, const Valley& b) { return a.minimum.misfit < b.minimum.misfit; };
  std::stable_sort(valleys.begin(), valleys.end(), lower);
  if (valleys.size() > most) valleys.erase(valleys.begin() + static_cast<std::ptrdiff_t>(most), valleys.end());
  narrow(valleys, misfit);
  trim_sides(valleys, misfit);
  weigh_all(valleys, misfit);
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
