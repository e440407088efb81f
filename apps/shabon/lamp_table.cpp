#include "lamp_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "json.h"
#include "shabon/base/text.h"
#include "shabon/color/temperature.h"
#include "shabon/color/xyz.h"
#include "shabon/io/csv.h"

namespace shabon::app {

namespace {

// Linear between the whole nanometres.
double at_wavelength(const color::Spectrum& spectrum, double wavelength_nm) {
  const double place = std::clamp(wavelength_nm - color::first_nm, 0.0, double(spectrum.size() - 1));
  const std::size_t left = std::min(static_cast<std::size_t>(place), spectrum.size() - 2);
  const double share = place - static_cast<double>(left);
  return spectrum[left] * (1 - share) + spectrum[left + 1] * share;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return printable(line);
}

std::string heading(const color::Illuminant& lamp, const color::Observer& observer) {
  const color::Xy xy = color::chromaticity(color::white_point(lamp, observer));
  const auto temperature = color::correlated_color_temperature(color::chromaticity(color::white_point(lamp)));
  const std::string kelvin =
      temperature ? fmt::format(", CCT {:.0f} K, Duv {:+.4f}", temperature->kelvin, temperature->duv) : "";
  return fmt::format("{}: {}\n  x {:.5f}, y {:.5f} (observer {}){}\n  {}\n", printable(lamp.name),
                     one_line(lamp.description), xy.x, xy.y, observer.name, kelvin, one_line(lamp.source));
}

}  // namespace

std::string lamp_table_text(const LampTable& table) {
  constexpr int column = 14;
  std::string text, heads = fmt::format("{:>{}}", "wavelength_nm", column);
  for (const color::Illuminant& lamp : table.lamps) {
    text += heading(lamp, table.observer);
    heads += fmt::format(" {:>{}}", printable(lamp.name), column);
  }
  text += '\n' + heads + '\n';
  for (const double wavelength_nm : table.wavelengths_nm) {
    text += fmt::format("{:>{}}", format_number(wavelength_nm, 9), column);
    for (const color::Illuminant& lamp : table.lamps)
      text += fmt::format(" {:>{}}", format_number(at_wavelength(lamp.power, wavelength_nm), 7),
                          std::max<std::size_t>(column, printable(lamp.name).size()));
    text += '\n';
  }
  return text;
}

std::string lamp_table_csv(const LampTable& table) {
  std::string csv, heads = "wavelength_nm";
  for (const color::Illuminant& lamp : table.lamps) {
    csv += fmt::format("# {}: {}; {}\n", one_line(lamp.name), one_line(lamp.description), one_line(lamp.source));
    heads += table.lamps.size() == 1 ? ",power" : "," + io::csv_cell(lamp.name);
  }
  csv += heads + '\n';
  for (const double wavelength_nm : table.wavelengths_nm) {
    csv += format_number(wavelength_nm);
    for (const color::Illuminant& lamp : table.lamps)
      csv += "," + format_exact(at_wavelength(lamp.power, wavelength_nm));
    csv += '\n';
  }
  return csv;
}

std::string lamp_table_json(const LampTable& table) {
  std::string list;
  for (const color::Illuminant& lamp : table.lamps) {
    const color::Xyz white = color::white_point(lamp, table.observer);
    const color::Xy xy = color::chromaticity(white);
    const auto temperature = color::correlated_color_temperature(color::chromaticity(color::white_point(lamp)));
    std::vector<double> powers;
    for (const double wavelength_nm : table.wavelengths_nm) powers.push_back(at_wavelength(lamp.power, wavelength_nm));
    JsonObject json;
    json.add("name", lamp.name).add("description", lamp.description).add("source", lamp.source);
    json.add("XYZ", {white.x, white.y, white.z}).add("xy", {xy.x, xy.y});
    json.add_json("cct_kelvin", temperature ? json_number(temperature->kelvin) : "null");
    json.add_json("duv", temperature ? json_number(temperature->duv) : "null");
    json.add("power", powers);
    list += (list.empty() ? "\n    " : ",\n    ") + json.line();
  }
  return JsonObject()
      .add("observer", table.observer.name)
      .add("wavelength_nm", table.wavelengths_nm)
      .add_json("lamps", "[" + list + "\n  ]")
      .text();
}

io::Chart lamp_chart(const LampTable& table) {
  io::Chart chart;
  const bool one = table.lamps.size() == 1;
  chart.title = one ? "Lamp " + table.lamps.front().name : "Lamps";
  if (one) chart.subtitle = table.lamps.front().description;
  chart.x.label = "vacuum wavelength (nm)";
  chart.y.label = "radiance per nm at Y = 1";
  chart.y.low = 0;
  std::vector<double> wavelengths_nm = table.wavelengths_nm;
  std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
  for (const color::Illuminant& lamp : table.lamps) {
    const color::Spectrum radiance = color::lamp_radiance(lamp, table.observer);
    io::ChartSeries& line = chart.series.emplace_back();
    if (!one) line.label = lamp.name;
    line.x = wavelengths_nm;
    for (const double wavelength_nm : wavelengths_nm) line.y.push_back(at_wavelength(radiance, wavelength_nm));
  }
  return chart;
}

}  // namespace shabon::app
