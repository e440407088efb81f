// shabon lamps: the lamps and observers of the library with their sources.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "json.h"
#include "options.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/xyz.h"
#include "streams.h"

namespace shabon::app {

namespace {

std::string lamps_text() {
  std::string text = fmt::format("Lamps, {}..{} nm at 1 nm\n", color::first_nm, color::last_nm);
  text += fmt::format("{:<8} {:<8} {:<8} {}\n", "name", "x", "y", "what and whose");
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xy xy = color::chromaticity(color::white_point(lamp));
    text +=
        fmt::format("{:<8} {:<8.5f} {:<8.5f} {}\n{:26} {}\n", lamp.name, xy.x, xy.y, lamp.description, "", lamp.source);
  }
  text += fmt::format("\nObservers\n{:<26} {}\n", "name", "what and whose");
  for (const color::Observer& observer : color::observers())
    text += fmt::format("{:<26} {}\n{:26} {}\n", observer.name, observer.description, "", observer.source);
  return text;
}

std::string lamps_json() {
  std::string lamps, observers;
  for (const color::Illuminant& lamp : color::illuminants()) {
    const color::Xy xy = color::chromaticity(color::white_point(lamp));
    JsonObject json;
    json.add("name", lamp.name).add("description", lamp.description).add("source", lamp.source);
    json.add("range_nm", {color::first_nm, color::last_nm}).add("xy", {xy.x, xy.y});
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

struct Format {
  std::string_view name;
  std::string (*write)();
};

constexpr Format formats[] = {{"text", lamps_text}, {"json", lamps_json}};

}  // namespace

Action declare_lamps(CLI::App& app) {
  const auto format = std::make_shared<std::size_t>(0);
  add_choice(app, "--format", *format, formats, "Form of the output");
  app.footer(R"(Names ignore case. x and y are the chromaticity for the observer 1931.

Example:
  shabon lamps)");
  return [format] { return print_result(formats[*format].write()); };
}

}  // namespace shabon::app
