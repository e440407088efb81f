// One unknown thickness: all minima of a misfit over a range, and how the probability is shared out among them (48).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace shabon::desk {

// The misfit, -2 ln(likelihood) up to a constant, at many thicknesses at once; finite.
using Misfit = std::function<std::vector<double>(const std::vector<double>& thicknesses_nm)>;

struct ScanRange {
  double low_nm = 0, high_nm = 0;
  double step_nm = 1;  // fine enough that no two minima lie within two steps
};

struct ScanMinimum {
  double thickness_nm = 0;
  double misfit = 0;
  bool at_end = false;                               // of the range
  double weight = 0;                                 // share of the probability of its valley, 0..1
  double interval_low_nm = 0, interval_high_nm = 0;  // 95 % of that share, as much on each side outside
};

inline constexpr double credible_share = 0.95;

// The minima of the lowest misfit first, at most `most`; where the misfit is level, one of its places.
std::vector<ScanMinimum> scanned_minima(const Misfit& misfit, const ScanRange& range, std::size_t most);

// How many of them it takes, the heaviest first, to hold 95 % of the weight.
std::size_t count_credible(std::vector<double> weights);

}  // namespace shabon::desk
