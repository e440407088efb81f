// The numbers that `shabon spectrum` prints, and their forms as text.
#pragma once

#include <string>

#include "shabon/desk/film_table.h"
#include "shabon/optics/interference.h"

namespace shabon::app {

struct SpectrumTable {
  std::string expression;
  optics::Interference interference = optics::Interference::airy;
  bool reversed = false;  // the light comes from the other side of the stack
  desk::FilmTable film;
};

// Numbers with 17 digits. With several angles, angle_deg is the first column.
std::string spectrum_csv(const SpectrumTable& table);
// The same columns, lined up, with 6 digits after the point.
std::string spectrum_text(const SpectrumTable& table);
// An object of columns of equal length, as in the CSV; angle_deg is always there.
std::string spectrum_json(const SpectrumTable& table);

}  // namespace shabon::app
