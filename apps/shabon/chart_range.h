// Ranges as charts take them: A:B or A:B:STEP, with units.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shabon/base/field.h"

namespace shabon::app {

struct ChartRange {
  double low = 0, high = 0;
  std::optional<double> step;

  // The step, or else a round number (1, 2 or 5 times a power of ten) that makes at least `parts` of the range.
  double step_or(int parts) const;
  // low, low + apart and so on up to high, with high itself when the steps reach it.
  std::vector<double> values(double apart) const;
};

// Several numbers, as a list or as a range; at most one of them.
struct ChartAngles {
  std::optional<ChartRange> range;
  std::vector<double> list;

  // All of them, a range in steps of 10 unless it says; `usual` when nothing was given.
  std::vector<double> values(const std::vector<double>& usual) const;
};

struct RangeUnit {
  std::string_view name;
  double factor;  // one of it in the unit that the range is in
};

inline constexpr RangeUnit length_units[] = {{"nm", 1},        {"um", 1e3}, {"\u00B5m", 1e3},
                                             {"\u03BCm", 1e3}, {"mm", 1e6}, {"cm", 1e7}};
inline constexpr RangeUnit angle_units[] = {{"deg", 1}, {"\u00B0", 1}};

// "0:2000nm", "0:2um:5nm". A part without unit has that of the second part (the first of `units` when it has none).
// Usage errors: another form, a part outside `allowed`, an end that is not above the begin, more than `most` values.
ChartRange range_in(const std::string& option, std::string_view text, std::span<const RangeUnit> units, Range allowed,
                    std::size_t most);

}  // namespace shabon::app
