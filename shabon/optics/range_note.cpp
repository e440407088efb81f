#include "shabon/optics/range_note.h"

#include <algorithm>

#include "shabon/base/text.h"

namespace shabon::optics {

namespace {

std::string nm(double wavelength_nm) { return format_number(wavelength_nm, 6) + " nm"; }
std::string held_at(double wavelength_nm) { return "the value at " + nm(wavelength_nm) + " is held"; }

// Of tables of n and of k that do not end together.
const std::string known_in_part = "one of n and k is known, the end value of the other is held";

void extend(std::optional<AskedBeyond>& side, double wavelength_nm, bool below) {
  if (!side) side = AskedBeyond{wavelength_nm, wavelength_nm};
  const auto [low, high] = std::minmax({side->farthest_nm, side->nearest_nm, wavelength_nm});
  side = below ? AskedBeyond{low, high} : AskedBeyond{high, low};
}

// Distances outwards from the end of the range, so that both sides read alike.
struct Outwards {
  double known_nm;      // the end of what the source says about n
  double continued_nm;  // the end of where the formula is used
  double sign;          // -1 below, 1 above

  bool beyond(double a_nm, double b_nm) const { return sign * (a_nm - b_nm) > 0; }
};

std::string note(const char* side, const FormulaIndex& formula, AskedBeyond asked, const Outwards& end) {
  std::string text = side;
  if (!end.beyond(asked.farthest_nm, end.known_nm))
    text += "n follows the formula";
  else if (end.known_nm == end.continued_nm || end.beyond(asked.nearest_nm, end.continued_nm))
    text += held_at(end.continued_nm);
  else if (!end.beyond(asked.farthest_nm, end.continued_nm))
    text += "the formula is continued";
  else
    text += "the formula is continued to " + nm(end.continued_nm) + " and its value there held beyond";
  if (formula.absorption.empty()) return text;
  const double k_end_nm =
      end.sign < 0 ? formula.absorption.front().wavelength_nm : formula.absorption.back().wavelength_nm;
  return end.beyond(asked.farthest_nm, k_end_nm) ? text + ", k of " + nm(k_end_nm) + " is held" : text;
}

}  // namespace

AskedOutside asked_outside(WavelengthRange range, std::span<const double> wavelengths_nm) {
  AskedOutside asked;
  for (const double wavelength_nm : wavelengths_nm) {
    if (wavelength_nm < range.first_nm) extend(asked.below, wavelength_nm, true);
    if (wavelength_nm > range.last_nm) extend(asked.above, wavelength_nm, false);
  }
  return asked;
}

AskedOutside asked_outside(WavelengthRange range, WavelengthRange asked) {
  AskedOutside result;
  if (asked.first_nm < range.first_nm)
    result.below = AskedBeyond{asked.first_nm, std::min(asked.last_nm, range.first_nm)};
  if (asked.last_nm > range.last_nm) result.above = AskedBeyond{asked.last_nm, std::max(asked.first_nm, range.last_nm)};
  return result;
}

std::string note_below(const FormulaIndex& formula, AskedBeyond asked) {
  return note("below, ", formula, asked, {formula.range.first_nm, formula.continued.first_nm, -1});
}

std::string note_above(const FormulaIndex& formula, AskedBeyond asked) {
  return note("above, ", formula, asked, {formula.range.last_nm, formula.continued.last_nm, 1});
}

std::string note_below(const TableIndex& table, AskedBeyond asked) {
  const double end_nm = table.rows.front().wavelength_nm;
  return "below, " + (asked.farthest_nm < end_nm ? held_at(end_nm) : known_in_part);
}

std::string note_above(const TableIndex& table, AskedBeyond asked) {
  const double end_nm = table.rows.back().wavelength_nm;
  return "above, " + (asked.farthest_nm > end_nm ? held_at(end_nm) : known_in_part);
}

}  // namespace shabon::optics
