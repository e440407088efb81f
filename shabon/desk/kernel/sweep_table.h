// A stack cut at the layer whose thickness is swept (45): what stands above and below it is computed once for each
// wavelength; what is left for each thickness is real arithmetic (46).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shabon/optics/incidence.h"
#include "shabon/optics/stack.h"

namespace shabon::desk {

// Rows are padded to a multiple of this many wavelengths; the padding reflects and transmits nothing.
inline constexpr std::size_t sweep_row_multiple = 16;

// |X0 + X1 w|^2 = (gap + far lost)^2 + kept (cosine cos(phi) + sine sin(phi))^2 with w = kept e^(2 i phi) and
// lost = 1 - kept, for many wavelengths (46).
struct SquareRows {
  std::vector<double> gap, far, cosine, sine;
};

// One polarisation: R = reflected/incident, T = passed kept/incident.
struct PolarisationRows {
  SquareRows incident, reflected;
  std::vector<double> passed;
};

struct SweepTable {
  std::size_t wavelengths = 0;            // without the padding
  std::size_t padded = 0;                 // length of every row
  std::vector<double> half_turns_per_nm;  // of phi: phi = pi half_turns_per_nm d
  std::vector<double> halvings_per_nm;    // of kept: kept = 2^-(halvings_per_nm d)
  PolarisationRows s, p;
  bool lossless = true;                    // kept = 1 at every wavelength
  bool normal_incidence = false;           // p is s
  std::vector<std::size_t> near_critical;  // wavelengths that (46) is not fit for; their rows are like the padding
};

// Coherent layers only, layer < stack.layers.size(), cos_i > 0, wavelengths > 0 in vacuum.
SweepTable sweep_table(const optics::Stack& stack, std::size_t layer, optics::Incidence incidence,
                       std::span<const double> wavelengths_nm);

}  // namespace shabon::desk
