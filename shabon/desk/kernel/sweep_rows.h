// The thicknesses of a sweep, for many wavelengths at once (46).
#pragma once

#include <span>

#include "shabon/color/xyz.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/kernel/sweep_table.h"

namespace shabon::desk {

// The unpolarised share at one thickness into `row`, table.padded long.
void sweep_row(const SweepTable& table, Side side, double thickness_nm, std::span<double> row);

// Beyond so many fringes within a stretch whole ones are what counts, and one whole fringe has the mean of all.
inline constexpr double many_fringes = 2;
// Where a mean looks, evenly spaced.
inline constexpr int looks_at_fringes = 32;

// The same as means over stretches of wavelength, each around its own: while the light's wavelength runs through one,
// it passes fringes_per_nm[i] thickness_nm fringes of the swept layer, all else being held (17). Up to `most_fringes`
// of them one wavelength stands for the stretch.
void sweep_row_means(const SweepTable& table, Side side, std::span<const double> fringes_per_nm, double most_fringes,
                     double thickness_nm, std::span<double> row);

// What each wavelength adds to X, Y and Z for a share of 1: rows of table.padded, 0 in the padding.
struct XyzRows {
  std::vector<double> x, y, z;
};

// The colour of each thickness into `colours`, of the same size.
void sweep_xyz(const SweepTable& table, Side side, const XyzRows& weights, std::span<const double> thicknesses_nm,
               std::span<color::Xyz> colours);

}  // namespace shabon::desk
