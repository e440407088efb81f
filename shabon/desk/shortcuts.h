// Ways in which programs simplify the colour of a film: one list. docs/shortcuts.md shows how far they are off.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/color/xyz.h"
#include "shabon/desk/sweep.h"

namespace shabon::desk {

struct Shortcut {
  std::string_view name;
  std::string_view description;  // what it does, in one line
  std::string_view used_by;      // who does it, or where it is written
  // Why it has no answer for this film, or nothing. Looks at everything but the thicknesses.
  std::string_view (*unfit)(const Sweep& film);
  // The colour of every thickness, of a film that it fits and for which swept_colors() has an answer. Under the same
  // lamp and on the same scale as swept_colors(); RGB is taken as linear sRGB, unclipped.
  std::vector<color::Xyz> (*colors)(const Sweep& film, const color::Illuminant& lamp, const color::Observer& observer);
};

// All of them. The interference model of the film is left aside.
std::span<const Shortcut> shortcuts();

// By name, ignoring case; nullptr when unknown.
const Shortcut* find_shortcut(std::string_view name);

// The vacuum wavelengths, nm, that stand for red, green and blue in `three-wavelengths`: the numbers that circulate in
// shaders.
inline constexpr double red_nm = 650, green_nm = 510, blue_nm = 475;

// Where `no-dispersion` and the other shortcuts of one index take it: the sodium D line (mean of the doublet), for
// which tables give n_D.
inline constexpr double sodium_nm = 589.3;

// The samples of `coarse-sampling`.
inline constexpr int coarse_first_nm = 380, coarse_last_nm = 780, coarse_step_nm = 10;

}  // namespace shabon::desk
