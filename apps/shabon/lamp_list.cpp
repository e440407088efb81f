#include <fmt/format.h>

#include "json.h"
#include "lamp_table.h"
#include "shabon/base/text.h"
#include "shabon/color/temperature.h"
#include "shabon/color/xyz.h"
#include "shabon/io/csv.h"

namespace shabon::app {

namespace {

std::string kelvin_text(color::Xy xy) {
  const auto temperature = color::correlated_color_temperature(xy);
  return temperature ? fmt::format("{:.0f} K", temperature->kelvin) : "";
}

// Every source once, behind the names that it is the source of.
template <class Entries>
std::string sources_text(const Entries& entries) {
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::size_t last = i;
    while (last + 1 < entries.size() && entries[last + 1].source == entries[i].source) ++last;
    const std::string names =
        last > i ? fmt::format("{} to {}", entries[i].name, entries[last].name) : std::string(entries[i].name);
    text += fmt::format("  {}: {}\n", names, entries[i].source);
    i = last;
  }
  return text;
}

}  // namespace

std::string lamp_list_text() {
  std::string text = fmt::format("Lamps, {}..{} nm at 1 nm\n", color::first_nm, color::last_nm);
  text += fmt::format("{:<10} {:<8} {:<8} {:>8}  {}\n", "name", "x", "y", "CCT", "what");
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xy xy = color::chromaticity(color::white_point(lamp));
    text +=
        fmt::format("{:<10} {:<8.5f} {:<8.5f} {:>8}  {}\n", lamp.name, xy.x, xy.y, kelvin_text(xy), lamp.description);
  }
  text += "and blackbody:3000K (1000..100000 K), daylight:5000K (4000..25000 K), file:PATH\n\nObservers\n";
  for (const color::Observer& observer : color::observers())
    text += fmt::format("{:<10} {}\n", observer.name, observer.description);
  return text + "\nSources\n" + sources_text(color::illuminants()) + sources_text(color::observers());
}

std::string lamp_list_csv() {
  std::string csv = "name,x,y,cct_kelvin,duv,description,source\n";
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xy xy = color::chromaticity(color::white_point(lamp));
    const auto temperature = color::correlated_color_temperature(xy);
    csv += fmt::format("{},{},{},{},{},{},{}\n", io::csv_cell(lamp.name), format_exact(xy.x), format_exact(xy.y),
                       temperature ? format_exact(temperature->kelvin) : "",
                       temperature ? format_exact(temperature->duv) : "", io::csv_cell(lamp.description),
                       io::csv_cell(lamp.source));
  }
  return csv;
}

std::string lamp_list_json() {
  std::string lamps, observers;
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xy xy = color::chromaticity(color::white_point(lamp));
    const auto temperature = color::correlated_color_temperature(xy);
    JsonObject json;
    json.add("name", lamp.name).add("description", lamp.description).add("source", lamp.source);
    json.add("range_nm", {color::first_nm, color::last_nm}).add("xy", {xy.x, xy.y});
    json.add_json("cct_kelvin", temperature ? json_number(temperature->kelvin) : "null");
    json.add_json("duv", temperature ? json_number(temperature->duv) : "null");
    lamps += (lamps.empty() ? "\n    " : ",\n    ") + json.line();
  }
  for (const color::Observer& observer : color::observers()) {
    JsonObject json;
    json.add("name", observer.name).add("description", observer.description).add("source", observer.source);
    json.add("range_nm", {color::first_nm, color::last_nm});
    observers += (observers.empty() ? "\n    " : ",\n    ") + json.line();
  }
  return JsonObject().add_json("lamps", "[" + lamps + "\n  ]").add_json("observers", "[" + observers + "\n  ]").text();
}

}  // namespace shabon::app
