// From a built-in table to the fixed-size spans of this room.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

#include "shabon/base/table.h"
#include "shabon/color/spectrum.h"

// Defined in the build tree by cmake/ShabonTables.cmake.
namespace shabon::tables {
std::span<const Table> observers();
std::span<const Table> illuminants();
std::span<const Table> lamp_series();  // a column for each lamp, named after it
std::span<const Table> daylight();     // S0, S1, S2 at 5 nm
std::span<const Table> sunlight();     // irradiance and absorption coefficients, finer where they change
std::span<const Table> rgb_basis();
}  // namespace shabon::tables

namespace shabon::color {

// The column after the wavelengths, counted from 1. The table must cover 360..830 nm at 1 nm; the tests see to it.
inline SpectrumView spectrum_column(const Table& table, std::size_t column) {
  assert(column < table.columns.size() && table.columns[column].size() == spectrum_size);
  assert(table.columns[0].front() == first_nm && table.columns[0].back() == last_nm);
  return table.columns[column].first<spectrum_size>();
}

}  // namespace shabon::color
