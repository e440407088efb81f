// How far the shortcuts are from the exact colour of a film, over its thickness.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/shortcuts.h"
#include "shabon/desk/sweep.h"

namespace shabon::desk {

struct DifferenceSummary {
  double mean = 0, median = 0;
  double percentile_95 = 0;  // the smallest difference that at least 95 % of all do not exceed
  double largest = 0;
  double largest_at_nm = 0;  // the first thickness with the largest
};

// Both of the same length; all 0 when empty.
DifferenceSummary summary_of(std::span<const double> thicknesses_nm, std::span<const double> differences);

struct ShortcutSeries {
  const Shortcut* shortcut = nullptr;
  std::string_view unfit;           // why it has no answer; then nothing follows
  std::vector<color::Xyz> colors;   // of every thickness
  std::vector<double> differences;  // CIEDE2000 to the exact colour (21)
  DifferenceSummary summary;
};

struct Comparison {
  std::vector<color::Xyz> exact;          // of every thickness; 1 nm sampling, all reflections, both polarisations
  std::vector<ShortcutSeries> shortcuts;  // as listed
};

// All shortcuts for this film; film.interference is not used. The white of Lab is the lamp. `brightness` (> 0)
// multiplies the exact and the shortened colour before they are compared: a film alone is dark, and a picture may be
// exposed for it. Errors: those of swept_colors(); a swept layer that is not coherent has no colours to compare.
Result<Comparison> compare(const Sweep& film, const color::Illuminant& lamp,
                           const color::Observer& observer = color::observer_1931(), double brightness = 1);

}  // namespace shabon::desk
