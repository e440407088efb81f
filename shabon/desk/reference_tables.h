// Tables of standard films for testing other programs: what they reflect and transmit, and their colours, as CSV with
// everything in it that is needed to compute them again. docs/reference-tables.md says how to use them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::desk {

// Raised when numbers, columns or names change, not when films are added.
inline constexpr int reference_tables_version = 1;

// Every file begins with these words.
inline constexpr std::string_view reference_marker = "# Shabon reference tables";

// Of incidence, in the first medium.
inline constexpr std::array<double, 5> reference_angles_deg = {0, 30, 45, 60, 80};

// Of the spectra: 360, 370, ... 830 nm, in vacuum.
inline constexpr int reference_first_nm = 360, reference_last_nm = 830, reference_step_nm = 10;

// Of the colours: daylight, a filament, and a lamp of narrow lines. The observer is that of 1931.
inline constexpr std::array<std::string_view, 3> reference_lamps = {"D65", "A", "FL11"};

struct ReferenceFilm {
  std::string_view name;        // its files are NAME-spectra.csv and NAME-colors.csv
  std::string_view title;       // one line
  std::string_view expression;  // of media of the library; the layer with 0nm takes all thicknesses
  std::size_t layer = 0;        // that layer, an index
  std::vector<double> spectra_thicknesses_nm;
  double last_nm = 0, step_nm = 1;  // of the colours: 0, step, ... last
  bool transmits = false;           // whether there are colours of transmitted light too
};

// One list.
std::span<const ReferenceFilm> reference_films();

struct ReferenceFile {
  std::string name, description;
  std::size_t rows = 0;  // 0 for a text
  std::string text;      // all its bytes; lines end in '\n'
};

// The names, descriptions and rows of all files, without their text; index.csv and README.md are the last.
std::vector<ReferenceFile> reference_list();

// All files, about 5 MB, computed in double precision by the reference. The same bytes at every call, whatever the
// number of threads; on another machine the last digit of a number may be another, as its C library rounds.
// `program_version` is told in their heads.
std::vector<ReferenceFile> reference_files(std::string_view program_version);

}  // namespace shabon::desk
