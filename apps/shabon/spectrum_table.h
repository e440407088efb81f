// The numbers that `shabon spectrum` prints, and their forms as text.
#pragma once

#include <string>
#include <vector>

#include "shabon/optics/interference.h"
#include "shabon/optics/reference/powers.h"
#include "shabon/optics/stack.h"

namespace shabon::app {

struct SpectrumTable {
  std::string expression;
  optics::Interference interference = optics::Interference::airy;
  std::vector<double> incidence_deg, wavelengths_nm;
  std::vector<optics::Powers> powers;  // of every angle, and within it of every wavelength

  const optics::Powers& at(std::size_t angle, std::size_t wavelength) const {
    return powers[angle * wavelengths_nm.size() + wavelength];
  }
};

// One column of results.
struct SpectrumColumn {
  std::string_view name;
  double (*value)(const optics::Powers&);
};

inline constexpr SpectrumColumn spectrum_columns[] = {
    {"R_s", [](const optics::Powers& p) { return p.R_s; }},
    {"R_p", [](const optics::Powers& p) { return p.R_p; }},
    {"T_s", [](const optics::Powers& p) { return p.T_s; }},
    {"T_p", [](const optics::Powers& p) { return p.T_p; }},
    {"A_s", [](const optics::Powers& p) { return 1 - p.R_s - p.T_s; }},
    {"A_p", [](const optics::Powers& p) { return 1 - p.R_p - p.T_p; }},
};

// Computes the powers of a stack that can be computed (desk::check_computable).
void fill(SpectrumTable& table, const optics::Stack& stack);

std::string spectrum_csv(const SpectrumTable& table);
// An object of columns of equal length, as in the CSV; angle_deg is always there.
std::string spectrum_json(const SpectrumTable& table);

}  // namespace shabon::app
