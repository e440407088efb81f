// CIE 1976 L*a*b* and the CIEDE2000 colour difference, equation (21).
#pragma once

#include "shabon/color/xyz.h"

namespace shabon::color {

struct Lab {
  double L = 0, a = 0, b = 0;  // the usual names; L is 100 for the white
  constexpr bool operator==(const Lab&) const = default;
};

// CIE 15:2018 section 8.2.1, with the exact constants 216/24389 and 24389/27. `white` must be positive.
Lab xyz_to_lab(Xyz colour, Xyz white);
Xyz lab_to_xyz(Lab colour, Xyz white);

// Sharma, Wu, Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test data, and
// mathematical observations", Color Res. Appl. 30 (2005) 21-30, with k_L = k_C = k_H = 1. Symmetric.
double ciede2000(Lab first, Lab second);

}  // namespace shabon::color
