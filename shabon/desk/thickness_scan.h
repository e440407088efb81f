// One unknown thickness: all minima of a misfit over a range, and how the probability is shared out among them (48).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace shabon::desk {

// The misfit, -2 ln(likelihood) up to a constant, at many thicknesses at once; finite.
using Misfit = std::function<std::vector<double>(const std::vector<double>& thicknesses_nm)>;

struct ScanRange {
  double low_nm = 0, high_nm = 0;
  double step_nm = 1;  // fine enough that no two minima lie within two steps
};

struct Stretch {
  double low_nm = 0, high_nm = 0;
};

struct ScanMinimum {
  double thickness_nm = 0;
  double misfit = 0;
  bool at_end = false;                               // of the range
  double weight = 0;                                 // share of the probability of its valley, 0..1
  double interval_low_nm = 0, interval_high_nm = 0;  // the shortest with 95 % of that share; holds the thickness

  // Where the misfit stays as low as at the minimum, within level_misfit, and that is most of the interval: any place
  // of it is as good. The thickness is its middle, unless the minimum is lower than that.
  std::optional<Stretch> level = {};
};

inline constexpr double credible_share = 0.95;
// Misfits that differ by less are alike: the probability falls to 37 %, which in a valley such as a parabola holds for
// 72 % of the interval. Valleys that no higher crest parts are one (half a percent).
inline constexpr double level_misfit = 2, crest_misfit = 0.01;

// The minima of the lowest misfit first, at most `most`. Their weights make up 1 less what lies in the others.
std::vector<ScanMinimum> scanned_minima(const Misfit& misfit, const ScanRange& range, std::size_t most);

// How many of them it takes, the heaviest first, to hold 95 % of the weight; all where they hold less.
std::size_t count_credible(std::vector<double> weights);

}  // namespace shabon::desk
