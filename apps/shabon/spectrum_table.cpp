#include "spectrum_table.h"

#include <fmt/format.h>

#include <cmath>

#include "json.h"
#include "shabon/base/text.h"

namespace shabon::app {

namespace {

constexpr double shown_as_zero = 5e-7;  // in 6 digits, so that no sign is left before it

double shown(double value) { return std::abs(value) < shown_as_zero ? 0 : value; }

// Calls with the angle and wavelength of every row.
template <class Task>
void for_each_row(const desk::FilmTable& film, const Task& task) {
  for (std::size_t a = 0; a < film.incidence_deg.size(); ++a)
    for (std::size_t w = 0; w < film.wavelengths_nm.size(); ++w)
      task(film.row(a, w), film.incidence_deg[a], film.wavelengths_nm[w]);
}

}  // namespace

std::string spectrum_csv(const SpectrumTable& table) {
  const bool several_angles = table.film.incidence_deg.size() > 1;
  std::string csv = several_angles ? "angle_deg,wavelength_nm" : "wavelength_nm";
  for (const desk::FilmColumn& column : table.film.columns) (csv += ',') += column.name;
  csv += '\n';
  for_each_row(table.film, [&](std::size_t row, double incidence_deg, double wavelength_nm) {
    if (several_angles) csv += format_number(incidence_deg) + ",";
    csv += format_number(wavelength_nm);
    for (const desk::FilmColumn& column : table.film.columns) csv += "," + format_exact(column.values[row]);
    csv += '\n';
  });
  return csv;
}

std::string spectrum_text(const SpectrumTable& table) {
  const bool several_angles = table.film.incidence_deg.size() > 1;
  std::string text = printable(table.expression) + "\n" + std::string(optics::name_of(table.interference));
  if (table.reversed) text += ", light from the other side";
  if (!several_angles) text += fmt::format(", {} degrees", format_number(table.film.incidence_deg.front()));
  text += "\n\n";
  if (several_angles) text += fmt::format("{:>11}", "angle_deg");
  text += fmt::format("{:>14}", "wavelength_nm");
  for (const desk::FilmColumn& column : table.film.columns) text += fmt::format(" {:>11}", column.name);
  text += '\n';
  for_each_row(table.film, [&](std::size_t row, double incidence_deg, double wavelength_nm) {
    if (several_angles) text += fmt::format("{:>11}", format_number(incidence_deg, 6));
    text += fmt::format("{:>14}", format_number(wavelength_nm, 9));
    for (const desk::FilmColumn& column : table.film.columns)
      text += fmt::format(" {:>11.6f}", shown(column.values[row]));
    text += '\n';
  });
  return text;
}

std::string spectrum_json(const SpectrumTable& table) {
  std::vector<double> angles, wavelengths;
  for_each_row(table.film, [&](std::size_t, double incidence_deg, double wavelength_nm) {
    angles.push_back(incidence_deg);
    wavelengths.push_back(wavelength_nm);
  });
  JsonObject json;
  json.add("stack", table.expression).add("interference", optics::name_of(table.interference));
  if (table.reversed) json.add("reversed", true);
  json.add("angle_deg", angles).add("wavelength_nm", wavelengths);
  for (const desk::FilmColumn& column : table.film.columns) json.add(column.name, column.values);
  return json.text();
}

}  // namespace shabon::app
