// shabon color STACK: the colour of a film under a lamp.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "command.h"
#include "json.h"
#include "options.h"
#include "shabon/desk/film_color.h"
#include "shabon/desk/film_spectrum.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

struct ColorOptions {
  StackInput stack;
  std::optional<double> incidence_deg;
  std::size_t lamp = 0, observer = 0, format = 0;
  bool transmitted = false;
};

// What one colour was computed from; for the heading of the text.
struct Conditions {
  const StackInput& stack;
  double incidence_deg;
  const color::Illuminant& lamp;
  const color::Observer& observer;
  desk::Side side;
};

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

// Escape codes go to terminals only, unless they are asked for (bixense.com/clicolors) or refused (no-color.org).
bool swatch_wanted() { return !is_set("NO_COLOR") && (is_terminal_output() || is_set("CLICOLOR_FORCE")); }

std::string swatch(color::EncodedRgb colour) {
  const auto bytes = color::to_bytes(colour);
  return fmt::format("  \x1b[48;2;{};{};{}m        \x1b[0m", bytes[0], bytes[1], bytes[2]);
}

std::string row(std::string_view label, double a, double b, double c) {
  return fmt::format("{:<14}{:>10.6f} {:>10.6f} {:>10.6f}\n", label, a, b, c);
}

std::string row(std::string_view label, color::EncodedRgb colour) {
  const std::string patch = swatch_wanted() ? swatch(colour) : "";
  return fmt::format("{:<14}{:>10.6f} {:>10.6f} {:>10.6f}  {}{}\n", label, colour.r, colour.g, colour.b,
                     color::to_hex(colour), patch);
}

std::string color_text(const Conditions& conditions, const desk::Color& c) {
  std::string text = fmt::format(
      "{}\n{} at {} degrees, unpolarised, {}, lamp {}, observer {}\n\n", printable(conditions.stack.expression),
      conditions.side == desk::Side::reflected ? "reflected" : "transmitted", format_number(conditions.incidence_deg),
      optics::name_of(conditions.stack.interference()), conditions.lamp.name, conditions.observer.name);
  text += row("XYZ", c.xyz.x, c.xyz.y, c.xyz.z);
  text += fmt::format("{:<14}{:>10.6f} {:>10.6f}\n", "xy", c.xy.x, c.xy.y);
  text += row("Lab", c.lab.L, c.lab.a, c.lab.b);
  text += row("linear sRGB", c.linear_srgb.r, c.linear_srgb.g, c.linear_srgb.b);
  text += row("sRGB clipped", c.srgb);
  text += row("sRGB mapped", c.srgb_mapped);
  return text + (c.in_gamut ? "inside sRGB\n" : "outside sRGB\n");
}

std::string color_json(const Conditions&, const desk::Color& c) {
  JsonObject json;
  json.add("XYZ", {c.xyz.x, c.xyz.y, c.xyz.z}).add("xy", {c.xy.x, c.xy.y}).add("Lab", {c.lab.L, c.lab.a, c.lab.b});
  json.add("linear_srgb", {c.linear_srgb.r, c.linear_srgb.g, c.linear_srgb.b});
  json.add("srgb", {c.srgb.r, c.srgb.g, c.srgb.b}).add("hex", color::to_hex(c.srgb));
  json.add("srgb_mapped", {c.srgb_mapped.r, c.srgb_mapped.g, c.srgb_mapped.b});
  json.add("hex_mapped", color::to_hex(c.srgb_mapped)).add("in_gamut", c.in_gamut);
  return json.text();
}

struct Format {
  std::string_view name;
  std::string (*write)(const Conditions&, const desk::Color&);
};

constexpr Format formats[] = {{"text", color_text}, {"json", color_json}};

int run_color(const ColorOptions& options) {
  const Result<optics::Stack> stack = read_stack(options.stack);
  if (!stack) return report(stack.errors());

  const Conditions conditions{options.stack, options.incidence_deg.value_or(0), color::illuminants()[options.lamp],
                              color::observers()[options.observer],
                              options.transmitted ? desk::Side::transmitted : desk::Side::reflected};
  report(desk::range_warnings(*stack, std::vector<double>{color::first_nm, color::last_nm}));
  const color::Spectrum share = desk::unpolarised(
      *stack, options.stack.interference(), optics::incidence_from(Degrees(conditions.incidence_deg)), conditions.side);
  const desk::Color colour = desk::color_of(share, conditions.lamp, conditions.observer);
  return print_result(formats[options.format].write(conditions, colour));
}

}  // namespace

Action declare_color(CLI::App& app) {
  const auto options = std::make_shared<ColorOptions>();
  add_stack_input(app, options->stack);
  add_number(app, "--angle", options->incidence_deg, {.low = 0, .high = 90}, "degrees",
             "Angle of incidence in the first medium, 0..90 degrees [0]");
  add_choice(app, "--illuminant", options->lamp, color::illuminants(), "Lamp");
  add_choice(app, "--observer", options->observer, color::observers(), "Standard observer");
  app.add_flag("--transmitted", options->transmitted, "The transmitted instead of the reflected light");
  add_choice(app, "--format", options->format, formats, "Form of the output");
  app.footer(std::string(stack_help) + R"(
The light is unpolarised. Y of the perfect reflector is 1; the white of Lab is the lamp. 'clipped' cuts each component
of linear sRGB to 0..1, 'mapped' keeps hue and lightness and lowers the chroma until the colour lies inside sRGB.

Examples:
  shabon color 'air | water 300nm | air'
  shabon color 'air | water 300nm | air' --angle 60 --illuminant A --format json
  shabon color '1 | 1.38 99.6nm | 1.52' --transmitted)");
  return [options] { return run_color(*options); };
}

}  // namespace shabon::app
