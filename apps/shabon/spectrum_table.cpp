#include "spectrum_table.h"

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/desk/film_spectrum.h"

namespace shabon::app {

void fill(SpectrumTable& table, const optics::Stack& stack) {
  for (const double angle_deg : table.incidence_deg) {
    const optics::Incidence incidence = optics::incidence_from(Degrees(angle_deg));
    for (const double wavelength_nm : table.wavelengths_nm)
      table.powers.push_back(desk::film_powers(stack, table.interference, incidence, wavelength_nm));
  }
}

std::string spectrum_csv(const SpectrumTable& table) {
  const bool several_angles = table.incidence_deg.size() > 1;
  std::string csv = several_angles ? "angle_deg,wavelength_nm" : "wavelength_nm";
  for (const SpectrumColumn& column : spectrum_columns) (csv += ',') += column.name;
  csv += '\n';
  for (std::size_t a = 0; a < table.incidence_deg.size(); ++a) {
    for (std::size_t w = 0; w < table.wavelengths_nm.size(); ++w) {
      if (several_angles) csv += format_number(table.incidence_deg[a]) + ",";
      csv += format_number(table.wavelengths_nm[w]);
      for (const SpectrumColumn& column : spectrum_columns) csv += "," + format_exact(column.value(table.at(a, w)));
      csv += '\n';
    }
  }
  return csv;
}

std::string spectrum_json(const SpectrumTable& table) {
  std::vector<double> angles, wavelengths;
  for (const double angle_deg : table.incidence_deg) {
    angles.insert(angles.end(), table.wavelengths_nm.size(), angle_deg);
    wavelengths.insert(wavelengths.end(), table.wavelengths_nm.begin(), table.wavelengths_nm.end());
  }
  JsonObject json;
  json.add("stack", table.expression).add("interference", optics::name_of(table.interference));
  json.add("angle_deg", angles).add("wavelength_nm", wavelengths);
  for (const SpectrumColumn& column : spectrum_columns) {
    std::vector<double> values;
    for (const optics::Powers& powers : table.powers) values.push_back(column.value(powers));
    json.add(column.name, values);
  }
  return json.text();
}

}  // namespace shabon::app
