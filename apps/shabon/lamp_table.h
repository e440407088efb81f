// The list that `shabon lamps` prints, and the spectra of `shabon lamps NAME...`.
#pragma once

#include <string>
#include <vector>

#include "shabon/color/illuminant.h"
#include "shabon/color/observer.h"
#include "shabon/io/svg.h"

namespace shabon::app {

std::string lamp_list_text();
std::string lamp_list_csv();
std::string lamp_list_json();

struct LampTable {
  std::vector<color::Illuminant> lamps;
  std::vector<double> wavelengths_nm;  // within 360..830
  color::Observer observer;            // of XYZ and x, y; the temperature is that of 1931
};

std::string lamp_table_text(const LampTable& table);
// wavelength_nm and a column a lamp: a lamp file that can be read again.
std::string lamp_table_csv(const LampTable& table);
std::string lamp_table_json(const LampTable& table);

// Radiance per nm of every lamp at Y = 1, so that the lines can be compared.
io::Chart lamp_chart(const LampTable& table);

}  // namespace shabon::app
