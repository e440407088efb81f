// What a medium does at wavelengths that its source does not cover, in words.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "shabon/optics/medium_index.h"

namespace shabon::optics {

// The wavelengths asked on one side of a range: the farthest from it and the nearest to it.
struct AskedBeyond {
  double farthest_nm = 0, nearest_nm = 0;
};

struct AskedOutside {
  std::optional<AskedBeyond> below, above;
};

AskedOutside asked_outside(WavelengthRange range, std::span<const double> wavelengths_nm);
AskedOutside asked_outside(WavelengthRange range, WavelengthRange asked);

// "below, the formula is continued" and the like, for a medium that is asked there.
std::string note_below(const FormulaIndex& formula, AskedBeyond asked);
std::string note_above(const FormulaIndex& formula, AskedBeyond asked);
std::string note_below(const TableIndex& table, AskedBeyond asked);
std::string note_above(const TableIndex& table, AskedBeyond asked);

}  // namespace shabon::optics
