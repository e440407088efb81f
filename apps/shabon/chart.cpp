// shabon chart KIND: options -> colours -> drawing and table -> files.
#include "chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "chart_files.h"
#include "command.h"
#include "lamp_input.h"
#include "options.h"
#include "picture_files.h"
#include "shabon/optics/stack_expression.h"
#include "shabon/scene/ranges.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_values = 20'001, most_angles = 1000, most_birefringences = 200, most_times = 24;
constexpr double drawing_width_in = 1000.0 / 96;
constexpr double most_dpi = 1200, least_dpi = 20, most_exposure_ev = 100;
constexpr long long least_width_px = 200, most_width_px = 12'500;

// An option that only some kinds of chart know.
struct SomeKinds {
  const CLI::Option* option;
  std::vector<std::string_view> kinds;
};

struct ChartCommand {
  std::optional<std::size_t> kind;  // of chart_kinds; there after the parse
  ChartOptions chart;
  std::string lamp = "D65";
  std::vector<std::string> outputs;
  std::optional<std::size_t> print;  // index of chart_file_kinds()
  std::optional<ChartExposure> exposure;
  std::optional<double> dpi;
  std::optional<long long> width_px;
  std::vector<SomeKinds> limited;
};

// The files that the stack and the lamp are read from, which no output may replace.
std::vector<std::filesystem::path> input_files(const ChartCommand& command) {
  std::vector<std::filesystem::path> files;
  const auto note = [&](std::string_view name, bool is_file) -> Result<optics::Medium> {
    if (is_file) files.emplace_back(name);
    return optics::Medium();
  };
  if (command.chart.expression) (void)optics::parse_stack(*command.chart.expression, note).ok();
  if (const auto file = color::illuminant_file(command.lamp)) files.emplace_back(*file);
  for (const std::filesystem::path& file : profile_files(command.chart)) files.push_back(file);
  return files;
}

// "newton, angle and profile".
std::string listed(const std::vector<std::string_view>& names) {
  const auto last = names.end() - 1;
  return fmt::format("{}{}{}", fmt::join(names.begin(), last, ", "), names.size() > 1 ? " and " : "", *last);
}

// Called while the options still exist, at the end of the parse.
void check_usage(const ChartCommand& command) {
  const std::string_view kind = chart_kinds[*command.kind].name;
  for (const SomeKinds& limited : command.limited) {
    const bool known = std::find(limited.kinds.begin(), limited.kinds.end(), kind) != limited.kinds.end();
    if (!known && limited.option->count() > 0)
      usage_error(limited.option->get_name(),
                  fmt::format("expected with {} only, got it with {}", listed(limited.kinds), kind));
  }
  if (command.print && !command.outputs.empty())
    usage_error("--format", "expected without --output, whose ending tells the format");
  if (command.dpi && command.width_px) usage_error("--width", "expected without --dpi, got both");
}

ChartPixels pixels_of(const ChartCommand& command) {
  if (command.width_px) return {static_cast<double>(*command.width_px) / drawing_width_in};
  return command.dpi ? ChartPixels{*command.dpi} : ChartPixels{};
}

// Writes what it can; the exit code of the first failure.
int write_all(const std::vector<ChartFile>& files, const MadeChart& chart, ChartPixels pixels) {
  int code = success;
  for (const ChartFile& file : files) {
    const Status written = write_chart(file, chart, pixels);
    if (written) {
      say(fmt::format("wrote {}", printable(file.path.string())));
      continue;
    }
    const int failed = report(written.errors());
    code = code == success ? failed : code;
  }
  return code;
}

int run_chart(ChartCommand& command) {
  const ChartKind& kind = chart_kinds[*command.kind];
  std::vector<std::string> names = command.outputs;
  if (names.empty() && !command.print) names.push_back(std::string(kind.name) + ".png");
  const Result<std::vector<ChartFile>> files = chart_files(names);
  if (!files) return report(files.errors());
  std::vector<std::filesystem::path> paths;
  for (const ChartFile& file : *files) paths.push_back(file.path);
  if (const Status writable = check_outputs(paths, input_files(command)); !writable) return report(writable.errors());

  Result<color::Illuminant> lamp = read_lamp(command.lamp);
  if (!lamp) return report(lamp.errors());
  command.chart.lamp = std::move(*lamp);
  command.chart.exposure = command.exposure.value_or(kind.exposure);
  const auto asked = [&](std::string_view form) {
    return (command.print && chart_file_kinds()[*command.print].name == form) ||
           std::any_of(files->begin(), files->end(), [&](const ChartFile& file) { return file.kind->name == form; });
  };
  command.chart.wants_table = asked("csv");
  command.chart.wants_drawing = asked("png") || asked("svg");
  const Result<MadeChart> chart = kind.make(command.chart);
  if (!chart) return report(chart.errors());
  report(chart->warnings);
  if (!command.print) return write_all(*files, *chart, pixels_of(command));
  const Result<std::string> bytes = chart_file_kinds()[*command.print].bytes(*chart, pixels_of(command));
  return bytes ? print_result(*bytes) : report(bytes.errors());
}

// One of the names, with no default that is the same for all kinds.
CLI::Option* add_optional_name(CLI::App& app, const std::string& name, std::optional<std::size_t>& target,
                               const std::vector<std::string_view>& names, const std::string& description) {
  const auto choose = [&target, name, names](const std::string& text) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (same_name(names[i], text)) target = i;
    if (!target) usage_error(name, unknown_name("value", text, names));
  };
  return app.add_option_function<std::string>(name, choose, description)->type_name("NAME");
}

// How thick a film is over a bubble.
void declare_thickness(CLI::App& app, ChartCommand& command) {
  const auto limit = [&](CLI::Option* option) { command.limited.push_back({option, {"profile"}}); };
  limit(add_text(
      app, "--model", command.chart.model, "MODEL",
      fmt::format("Thickness over the bubble, as below 'thickness' in a scene file [{}]", default_profile_model)));
  limit(add_numbers(app, "--time", command.chart.times_s, scene::time_range_s, "s", most_times,
                    "Moments, for models that age and for numbered maps, such as 0,4,16"));
}

// The options of films and of plates.
void declare_content(CLI::App& app, ChartCommand& command) {
  ChartOptions& chart = command.chart;
  const std::vector<std::string_view> films = {"newton", "angle", "profile"}, swept = {"newton", "angle"},
                                      ranged = {"newton", "angle", "michel-levy"}, levy = {"michel-levy"};
  const auto limit = [&](CLI::Option* option, std::vector<std::string_view> kinds) {
    command.limited.push_back({option, std::move(kinds)});
  };
  const auto add_range = [&](const std::string& name, std::optional<ChartRange>& target, const std::string& help) {
    const auto read = [&target, name](const std::string& text) {
      target = range_in(name, text, length_units, {.low = 0, .high = optics::largest_thickness_nm}, most_values);
    };
    return app.add_option_function<std::string>(name, read, help)->type_name("A:B[:STEP]");
  };
  limit(add_text(app, "STACK", chart.expression, "", "Stack expression [air | water 0nm | air]"), films);
  limit(add_integer(app, "--layer", chart.layer, 1, optics::most_layers,
                    "The layer whose thickness changes, counted from 1; its thickness in STACK is not used"),
        films);
  limit(add_range("--thickness", chart.thickness_nm,
                  "Thickness of the film, or of the mineral, with units: 0:2000nm, 0:2um:5nm [newton 0:2000nm, angle "
                  "0:1500nm, michel-levy 0:50um]"),
        ranged);
  const auto read_angles = [&chart](const std::string& text) {
    constexpr Range allowed{.low = 0, .high = 90};
    if (text.find(':') != std::string::npos) {
      chart.angles_deg.range = range_in("--angle", text, angle_units, allowed, most_angles);
    } else {
      chart.angles_deg.list = numbers_in("--angle", {text}, allowed, "degrees", most_angles);
    }
  };
  limit(app.add_option_function<std::string>("--angle", read_angles,
                                             "Angles of incidence in degrees: for newton a list such as 0,30,60 [0], "
                                             "for angle a range such as 0:80 [0:90], for profile one [0]")
            ->type_name("LIST|A:B[:STEP]"),
        films);
  std::vector<std::string_view> sides;
  for (const ChartSide& side : chart_sides()) sides.push_back(side.name);
  limit(add_optional_name(
            app, "--side", chart.side_index, sides,
            fmt::format("Side of the film: {} [newton both, angle and profile reflected]", fmt::join(sides, ", "))),
        films);
  limit(app.add_flag("--curves", chart.curves,
                     "newton: also curves of Y and linear sRGB; angle: also lines of equal path difference"),
        swept);
  limit(
      add_choice(app, "--interference", chart.interference_index, optics::interference_models, "Model of interference"),
      films);
  limit(add_range("--retardation", chart.retardation_nm, "Retardation, nm [0:2500nm]"), levy);
  limit(add_numbers(app, "--birefringence", chart.birefringences, {.low = 0, .high = 10, .low_open = true}, "",
                    most_birefringences, "The lines of the fan, such as 0.009,0.036 [0.001 to 0.3]"),
        levy);
  declare_thickness(app, command);
}

void declare_light(CLI::App& app, ChartCommand& command) {
  ChartOptions& chart = command.chart;
  add_lamp(app, command.lamp);
  add_choice(app, "--observer", chart.observer_index, color::observers(), "Standard observer");
  for (std::size_t i = 0; i < color::gamut_mappings().size(); ++i)
    if (color::gamut_mappings()[i].mapping == color::default_gamut_mapping) chart.gamut_index = i;
  add_choice(app, "--gamut", chart.gamut_index, color::gamut_mappings(), "What is shown for colours beyond sRGB");
  add_adaptation(app, chart.adaptation, "Adaptation of the drawing to the lamp, so that it looks white");
  const auto read_exposure = [&command](const std::string& text) {
    if (same_name(text, "each")) {
      command.exposure = ChartExposure::each;
    } else if (same_name(text, "one")) {
      command.exposure = ChartExposure::one;
    } else if (parse_number(text)) {
      command.exposure = ChartExposure::stops;
      command.chart.exposure_ev = number_in("--exposure", text, {.low = -most_exposure_ev, .high = most_exposure_ev});
    } else {
      constexpr std::string_view words[] = {"each", "one"};
      usage_error("--exposure", fmt::format("expected each, one or a number of stops, got {}", meant(text, words)));
    }
  };
  app.add_option_function<std::string>("--exposure", read_exposure,
                                       "Brightness of the drawing: each (the brightest colour of every angle or time "
                                       "gets Y = 1), one (the same factor for all) or stops, 0 for no change [each, "
                                       "profile one]")
      ->type_name("each|one|EV");
}

void declare_output(CLI::App& app, ChartCommand& command) {
  add_texts(app, "-o,--output", command.outputs, "FILE",
            "Chart to write, .png, .svg or .csv; may be repeated [KIND.png]");
  std::vector<std::string_view> names;
  for (const ChartFileKind& kind : chart_file_kinds()) names.push_back(kind.name);
  add_optional_name(app, "--format", command.print, names,
                    fmt::format("Print the chart instead of writing a file: {}", fmt::join(names, ", ")));
  add_number(app, "--dpi", command.dpi, {.low = least_dpi, .high = most_dpi}, "",
             "Pixels of a PNG to an inch; charts are 10.4 inches wide [240]");
  add_integer(app, "--width", command.width_px, least_width_px, most_width_px,
              "Pixels of a PNG from left to right [2500]");
}

std::string kinds_help() {
  std::string text = "\nKinds:\n";
  for (const ChartKind& kind : chart_kinds) text += fmt::format("  {:<12} {}\n", kind.name, kind.summary);
  return text;
}

constexpr const char* help_text = R"(
Light is unpolarised and a film by itself reflects little of it: charts are brightened, by the factors that they tell;
the numbers of a .csv are not. Colours are drawn in sRGB.

Examples:
  shabon chart newton
  shabon chart newton --angle 0,30,60 --side reflected -o newton.svg
  shabon chart newton 'air | TiO2 0nm | Ti' --thickness 0:300nm --curves -o titanium.png -o titanium.csv
  shabon chart newton 'air | MgF2 100nm | ZnS 0nm | glass' --layer 2 --illuminant A
  shabon chart angle 'air | 1.5 0nm | water' --thickness 0:1um --dpi 300
  shabon chart michel-levy -o michel-levy.png
  shabon chart profile --model '{self_similar: {top_nm: 300, bottom_nm: 1600}}' --time 0,4,16)";

}  // namespace

std::vector<ChartSide> chart_sides() {
  using enum desk::Side;
  return {{"both", {reflected, transmitted}}, {"reflected", {reflected}}, {"transmitted", {transmitted}}};
}

std::string_view name_of(desk::Side side) { return side == desk::Side::reflected ? "reflected" : "transmitted"; }

Action declare_chart(CLI::App& app) {
  const auto command = std::make_shared<ChartCommand>();
  std::vector<std::string_view> kinds;
  for (const ChartKind& kind : chart_kinds) kinds.push_back(kind.name);
  add_optional_name(app, "KIND", command->kind, kinds, fmt::format("What to draw: {}", fmt::join(kinds, ", ")))
      ->type_name("")
      ->required();
  declare_content(app, *command);
  declare_light(app, *command);
  declare_output(app, *command);
  app.footer(std::string(stack_help) + kinds_help() + help_text);
  app.callback([command] { check_usage(*command); });
  return [command] { return run_chart(*command); };
}

}  // namespace shabon::app
