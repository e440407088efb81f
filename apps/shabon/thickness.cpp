// shabon thickness STACK: from a colour or a spectrum back to the film.
#include "thickness.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <regex>

#include "chart_range.h"
#include "command.h"
#include "lamp_input.h"
#include "options.h"
#include "shabon/api/resolvers.h"
#include "shabon/color/adaptation.h"
#include "shabon/color/spaces.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/optics/stack_expression.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_angles = 100;
constexpr long long most_rows = 1000;

struct Format {
  std::string_view name;
  ThicknessFormat value;
};
constexpr Format formats[] = {
    {"text", ThicknessFormat::text}, {"json", ThicknessFormat::json}, {"csv", ThicknessFormat::csv}};

// Options that only one kind of question knows.
struct Limited {
  std::vector<const CLI::Option*> colors, spectra;
};

void check_usage(const ThicknessCommand& command, const Limited& limited) {
  const bool by_color = !command.colors.empty();
  if (by_color && command.spectrum_file) usage_error("--color", "expected without --spectrum, got both");
  if (!by_color && !command.spectrum_file) usage_error("--color", "expected this or --spectrum, got neither");
  for (const CLI::Option* option : by_color ? limited.spectra : limited.colors)
    if (option->count() > 0)
      usage_error(option->get_name(), fmt::format("expected with {} only", by_color ? "--spectrum" : "--color"));
  const std::size_t angles = command.incidence_deg.size(), colors = command.colors.size();
  if (by_color && angles > 1 && angles != colors)
    usage_error("--angle", fmt::format("expected one angle, or one for each colour ({}); got {}", colors, angles));
  if (!by_color && angles > 1)
    usage_error("--angle",
                fmt::format("expected one angle for a spectrum, got {}; several go into its column angle_deg", angles));
}

int run_thickness(const ThicknessCommand& command) {
  const ThicknessFormat format = formats[command.format].value;
  const Result<std::string> text =
      command.spectrum_file ? thickness_by_spectrum(command, format) : thickness_by_color(command, format);
  return text ? print_result(*text) : report(text.errors());
}

// A choice with no default of its own.
template <class Entries>
CLI::Option* add_optional_choice(CLI::App& app, const std::string& option, std::optional<std::size_t>& target,
                                 const Entries& entries, const std::string& description) {
  std::vector<std::string_view> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  const auto read = [&target, names, option](const std::string& text) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (same_name(names[i], text)) target = i;
    if (!target) usage_error(option, unknown_name("value", text, names));
  };
  return app.add_option_function<std::string>(option, read, fmt::format("{}: {}", description, fmt::join(names, ", ")))
      ->type_name("NAME");
}

void declare_film(CLI::App& app, ThicknessCommand& command) {
  app.add_option("STACK", command.expression, "Stack expression with ? for what is asked, 'air | water ? | air'")
      ->type_name("")
      ->required();
  const auto read = [&command](const std::string& text) {
    if (split(text, ':').size() != 2)
      usage_error("--range", fmt::format("expected A:B such as 100:900nm, got '{}'", printable(text, 60)));
    const ChartRange range =
        range_in("--range", text, length_units, {.low = 0, .high = optics::largest_thickness_nm}, 1);
    command.low_nm = range.low, command.high_nm = range.high;
  };
  app.add_option_function<std::string>("--range", read, "Where each ? is looked for, with units [0:2000nm]")
      ->type_name("A:B");
}

void declare_colors(CLI::App& app, ThicknessCommand& command, std::vector<const CLI::Option*>& limited) {
  std::string spaces;
  for (const color::ColorSpaceEntry& entry : color::color_spaces())
    spaces += (spaces.empty() ? "" : ", ") + std::string(entry.name);
  add_texts(app, "--color", command.colors, "COLOR",
            "#rrggbb (sRGB), or SPACE:A,B,C such as Lab:60,20,-30, in " + spaces +
                " (RGB: linear light); may be repeated, for several angles");
  const auto limit = [&](const CLI::Option* option) { limited.push_back(option); };
  limit(app.add_flag("--transmitted", command.transmitted, "The colour of the transmitted light"));
  add_lamp(app, command.lamp);
  limit(app.get_option("--illuminant"));
  add_choice(app, "--observer", command.observer, color::observers(), "Standard observer");
  limit(app.get_option("--observer"));
  limit(add_number(app, "--uncertainty", command.uncertainty, {.low = 0, .high = 100, .low_open = true}, "",
                   "Standard deviation of the colour, in CIEDE2000 [1]"));
  limit(app.add_flag("--ignore-lightness", command.ignore_lightness,
                     "The exposure is unknown, as in photographs: go by chromaticity alone"));
  limit(add_adaptation(app, command.adaptation,
                       "The colour's white is that of its space, by this chromatic adaptation from the lamp"));
  limit(add_optional_choice(app, "--gamut", command.mapping, color::gamut_mappings(),
                            "How a picture shows colours beyond sRGB [clip for #rrggbb]"));
}

void declare_spectra(CLI::App& app, ThicknessCommand& command, std::vector<const CLI::Option*>& limited) {
  add_text(app, "--spectrum", command.spectrum_file, "FILE",
           "Measured shares of light (.csv): wavelength_nm and any of R, R_s, R_p, T, T_s, T_p; perhaps angle_deg");
  const auto limit = [&](const CLI::Option* option) { limited.push_back(option); };
  const auto read = [&command](const std::string& text) {
    std::vector<std::string_view> names;
    for (const desk::QuantityEntry& entry : desk::quantities()) names.push_back(entry.name);
    for (const std::string_view part : split(text, ',')) {
      const auto found =
          std::find_if(names.begin(), names.end(), [&](auto name) { return same_name(name, trim(part)); });
      if (found == names.end()) usage_error("--columns", unknown_name("share", trim(part), names));
      const desk::Quantity quantity = desk::quantities()[static_cast<std::size_t>(found - names.begin())].quantity;
      if (std::find(command.columns.begin(), command.columns.end(), quantity) == command.columns.end())
        command.columns.push_back(quantity);
    }
  };
  limit(app.add_option_function<std::string>("--columns", read, "Only these shares of the file, such as R_s,R_p")
            ->type_name("LIST"));
  limit(app.add_flag("--percent", command.percent, "The shares are in percent"));
  limit(add_number(app, "--noise", command.noise, {.low = 0, .high = 1, .low_open = true}, "",
                   "Standard deviation of a share, 0..1 [told by the residuals, at least 0.0001]"));
  limit(app.add_flag("--ignore-scale", command.ignore_scale, "The shares have one unknown common factor"));
}

constexpr const char* help_text = R"(
What is asked is a '?' in place of a thickness, or a range: 'air | SiO2 100..900nm | Si'. A colour finds one thickness,
a spectrum up to four; in a repeated group a '?' is one thickness for all copies.

Every thickness that fits is listed with a weight: its share of the probability, were all thicknesses of the range
equally likely and the colour (or the spectrum) uncertain as stated. Exit code 0 also when nothing fits, which is said.

Examples:
  shabon thickness 'air | SiO2 ? | Si' --color '#7858a4'
  shabon thickness 'air | water ? | air' --color '#d9a7c7' --ignore-lightness
  shabon thickness 'air | TiO2 0..200nm | Ti' --color Lab:33,2,-48 --angle 20 --illuminant A
  shabon thickness 'air | water ? | air' --color '#504d3e' --color '#74797a' --angle 0,60
  shabon thickness 'air | SiO2 ? | Si' --spectrum wafer.csv --range 0:20um
  shabon thickness 'air | Si3N4 50..150nm | SiO2 ? | Si' --spectrum wafer.csv --format json)";

// At the first thickness, where a `?` could stand, or where the first layer would begin.
Diagnostic nothing_unknown(const std::string& expression) {
  static const std::regex thickness("[0-9.][0-9.eE+-]*[ \t]*(nm|um|\u00B5m|\u03BCm|mm|cm)(?![A-Za-z0-9_])");
  const std::size_t bar = std::min(expression.find('|'), expression.size());
  const std::string after = expression.substr(bar);
  std::smatch found;
  const bool has_layer = std::regex_search(after, found, thickness);
  const std::size_t at = has_layer ? bar + static_cast<std::size_t>(found.position()) : bar;
  Diagnostic error;
  error.source = "<stack>", error.excerpt = expression, error.line = 1;
  error.column = static_cast<int>(utf8_characters(std::string_view(expression).substr(0, at)).size()) + 1;
  error.message = "expected ? or a range such as 100..900nm in place of a thickness, got " +
                  (has_layer ? "'" + found.str() + "'" : std::string("no layer"));
  return error;
}

}  // namespace

Result<NamedFilm> read_unknown_film(const ThicknessCommand& command) {
  const auto parsed = optics::parse_stack_with_unknowns(command.expression, api::medium_resolver());
  if (!parsed) return parsed.errors();
  if (parsed->unknowns.empty()) return Diagnostics{nothing_unknown(command.expression)};
  NamedFilm named{{parsed->stack, {}}, {}};
  for (const optics::UnknownThickness& unknown : parsed->unknowns) {
    const optics::ThicknessRange range =
        unknown.range.value_or(optics::ThicknessRange{command.low_nm, command.high_nm});
    named.film.unknowns.push_back({unknown.layers, range.low_nm, range.high_nm});
    named.names.push_back(printable(parsed->stack.layers[unknown.layers.front()].medium.name(), 40));
  }
  const std::vector<std::string> media = named.names;
  for (std::size_t i = 0; i < media.size(); ++i)
    if (std::count(media.begin(), media.end(), media[i]) > 1)
      named.names[i] = fmt::format("{} (layer {})", media[i], parsed->unknowns[i].layers.front() + 1);
  return named;
}

std::string verdict_sentence(std::size_t in_95_percent) {
  return in_95_percent == 1
             ? "One of them holds 95 % of the probability."
             : fmt::format("Ambiguous: it takes {} of them to hold 95 % of the probability.", in_95_percent);
}

std::string_view verdict_word(std::size_t in_95_percent) { return in_95_percent == 1 ? "one" : "several"; }

std::string nm_text(double nm) { return fmt::format("{:.10g}", nm); }

std::string percent_text(double share) {
  constexpr double least = 0.001;
  if (share < least) return fmt::format("< {} %", 100 * least);
  if (share > 1 - least && share < 1) return fmt::format("> {} %", 100 * (1 - least));
  return fmt::format("{:.1f} %", 100 * share);
}

Action declare_thickness(CLI::App& app) {
  const auto command = std::make_shared<ThicknessCommand>();
  const auto limited = std::make_shared<Limited>();
  declare_film(app, *command);
  declare_colors(app, *command, limited->colors);
  declare_spectra(app, *command, limited->spectra);
  add_numbers(app, "--angle", command->incidence_deg, {.low = 0, .high = 90}, "degrees", most_angles,
              "Angle of incidence in the first medium, 0..90 degrees; a list gives each colour its own [0]");
  const auto read_most = [command](const std::string& text) {
    command->most = integer_in("--most", text, 1, most_rows);
  };
  app.add_option_function<std::string>("--most", read_most, "The most thicknesses to list [10]")->type_name("N");
  add_choice(app, "--format", command->format, formats, "Form of the output");
  app.footer(std::string(stack_help) + help_text);
  app.callback([command, limited] { check_usage(*command, *limited); });
  return [command] { return run_thickness(*command); };
}

}  // namespace shabon::app
