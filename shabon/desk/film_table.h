// The spectrum of a stack as a table: one row for every angle and wavelength, named columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "shabon/base/result.h"
#include "shabon/optics/interference.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

// What the table holds besides R, T and A. All of it needs `airy`; amplitudes and ellipsometry need coherent layers.
struct FilmTableDetails {
  // r_s_re, r_s_im and so on, the complex r and t of s and p, and their phases r_s_deg, r_p_deg, t_s_deg, t_p_deg.
  bool amplitudes = false;
  // psi_deg, delta_deg of the reflected light, psi_t_deg, delta_t_deg of the transmitted light.
  bool ellipsometry = false;
  // A_s_1, A_p_1, A_s_2, ...: what each layer absorbs, counted from the side the light comes from.
  bool layers = false;
};

// What a column is a measure of: columns of one kind share an axis.
enum class FilmQuantity { share, layer_share, amplitude, degrees };

struct FilmColumn {
  std::string name;
  FilmQuantity quantity = FilmQuantity::share;
  std::vector<double> values;  // of every row
};

struct FilmTable {
  std::vector<double> incidence_deg, wavelengths_nm;
  std::vector<FilmColumn> columns;  // R_s, R_p, T_s, T_p, A_s, A_p (A = 1 - R - T), then the details in their order

  std::size_t rows() const { return incidence_deg.size() * wavelengths_nm.size(); }
  // All wavelengths of the first angle, then of the next.
  std::size_t row(std::size_t angle, std::size_t wavelength) const {
    return angle * wavelengths_nm.size() + wavelength;
  }
};

// How many columns the table of this stack has.
std::size_t film_table_columns(const optics::Stack& stack, const FilmTableDetails& details);

// Angles of 0..90 degrees in the first medium, vacuum wavelengths > 0 in nm. Errors: a model that does not know the
// stack, or details that it does not know.
Result<FilmTable> film_table(const optics::Stack& stack, optics::Interference interference,
                             std::span<const double> incidence_deg, std::span<const double> wavelengths_nm,
                             const FilmTableDetails& details = {});

}  // namespace shabon::desk
