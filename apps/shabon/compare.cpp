// shabon compare STACK: how far common shortcuts are from the exact colour of a film.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "chart_files.h"
#include "command.h"
#include "compare_report.h"
#include "lamp_input.h"
#include "options.h"
#include "picture_files.h"
#include "shabon/optics/stack_expression.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr ChartRange default_thickness_nm{0, 1500, {}};
constexpr int least_parts = 1500;
constexpr std::size_t most_thicknesses = 20'001;
constexpr double most_exposure_ev = 100;

struct CompareCommand {
  ChartOptions film;  // the expression and the layer
  std::optional<double> incidence_deg;
  std::string lamp = "D65";
  std::size_t observer = 0, format = 0;
  bool transmitted = false;
  double exposure_ev = 0;
  bool exposure_fits = false;
  std::vector<std::string> outputs;
};

struct Format {
  std::string_view name;
  std::string (*write)(const CompareReport&);
};

std::string compare_svg(const CompareReport& report) { return io::chart_svg(compare_chart(report)); }

constexpr Format formats[] = {
    {"text", compare_text}, {"csv", compare_csv}, {"json", compare_json}, {"svg", compare_svg}};

// 2^EV, or what brings the brightest exact colour to Y = 1.
double brightness_of(const CompareCommand& command, const std::vector<color::Xyz>& exact) {
  if (!command.exposure_fits) return std::exp2(command.exposure_ev);
  double largest = 0;
  for (const color::Xyz& colour : exact) largest = std::max(largest, colour.y);
  return largest > 0 ? 1 / largest : 1;
}

Result<CompareReport> make_report(const CompareCommand& command) {
  Result<SweptFilm> film = read_swept_film(command.film);
  if (!film) return film.errors();
  Result<color::Illuminant> lamp = read_lamp(command.lamp);
  if (!lamp) return lamp.errors();
  CompareReport report;
  report.film = std::move(*film);
  report.lamp = std::move(*lamp);
  report.observer = &color::observers()[command.observer];
  report.incidence_deg = command.incidence_deg.value_or(0);
  const ChartRange range = command.film.thickness_nm.value_or(default_thickness_nm);
  report.sweep = {report.film.stack, report.film.layer, range.values(range.step_or(least_parts)),
                  optics::incidence_from(Degrees(report.incidence_deg)),
                  command.transmitted ? desk::Side::transmitted : desk::Side::reflected};
  if (command.exposure_fits) {
    const Result<std::vector<color::Xyz>> exact = desk::swept_colors(report.sweep, report.lamp, *report.observer);
    if (!exact) return exact.errors();
    report.brightness = brightness_of(command, *exact);
  } else {
    report.brightness = brightness_of(command, {});
  }
  Result<desk::Comparison> comparison = desk::compare(report.sweep, report.lamp, *report.observer, report.brightness);
  if (!comparison) return comparison.errors();
  report.comparison = std::move(*comparison);
  return report;
}

// The files that the stack and the lamp are read from, which no output may replace.
std::vector<std::filesystem::path> input_files(const CompareCommand& command) {
  std::vector<std::filesystem::path> files;
  const auto note = [&](std::string_view name, bool is_file) -> Result<optics::Medium> {
    if (is_file) files.emplace_back(name);
    return optics::Medium();
  };
  (void)optics::parse_stack(*command.film.expression, note).ok();
  if (const auto file = color::illuminant_file(command.lamp)) files.emplace_back(*file);
  return files;
}

int write_files(const std::vector<ChartFile>& files, const CompareReport& compared) {
  const MadeChart chart{compare_chart(compared), compare_csv(compared), {}};
  int code = success;
  for (const ChartFile& file : files) {
    const Status written = write_chart(file, chart, {});
    if (written) {
      say(fmt::format("wrote {}", printable(file.path.string())));
      continue;
    }
    const int failed = report(written.errors());
    code = code == success ? failed : code;
  }
  return code;
}

int run_compare(const CompareCommand& command) {
  const Result<std::vector<ChartFile>> files = chart_files(command.outputs);
  if (!files) return report(files.errors());
  std::vector<std::filesystem::path> paths;
  for (const ChartFile& file : *files) paths.push_back(file.path);
  if (const Status writable = check_outputs(paths, input_files(command)); !writable) return report(writable.errors());

  const Result<CompareReport> compared = make_report(command);
  if (!compared) return report(compared.errors());
  report(film_warnings(compared->film));
  report(power_notes(compared->film.stack, command.transmitted));
  return files->empty() ? print_result(formats[command.format].write(*compared)) : write_files(*files, *compared);
}

void add_exposure(CLI::App& app, CompareCommand& command) {
  const auto read = [&command](const std::string& text) {
    command.exposure_fits = same_name(text, "fit");
    constexpr std::string_view words[] = {"fit"};
    if (!command.exposure_fits && !parse_number(trim(text)))
      usage_error("--exposure", fmt::format("expected fit or a number of stops, got {}", meant(text, words)));
    if (!command.exposure_fits)
      command.exposure_ev = number_in("--exposure", text, {.low = -most_exposure_ev, .high = most_exposure_ev});
  };
  app.add_option_function<std::string>(
         "--exposure", read,
         "Stops by which all colours are brightened before they are compared, or 'fit': the brightest exact colour "
         "gets Y = 1 [0]")
      ->type_name("EV|fit");
}

}  // namespace

Action declare_compare(CLI::App& app) {
  const auto command = std::make_shared<CompareCommand>();
  add_text(app, "STACK", command->film.expression, "", "Stack expression, such as 'air | water 0nm | air'")->required();
  add_integer(app, "--layer", command->film.layer, 1, optics::most_layers,
              "The layer whose thickness changes, counted from 1; its thickness in STACK is not used");
  const auto read_thickness = [command](const std::string& text) {
    command->film.thickness_nm =
        range_in("--thickness", text, length_units, {.low = 0, .high = optics::largest_thickness_nm}, most_thicknesses);
  };
  app.add_option_function<std::string>("--thickness", read_thickness,
                                       "Thicknesses, with units: 0:2000nm, 0:2um:5nm [0:1500nm]")
      ->type_name("A:B[:STEP]");
  add_number(app, "--angle", command->incidence_deg, {.low = 0, .high = 90}, "degrees",
             "Angle of incidence in the first medium, 0..90 degrees [0]");
  app.add_flag("--transmitted", command->transmitted, "The transmitted light in place of the reflected");
  add_lamp(app, command->lamp);
  add_choice(app, "--observer", command->observer, color::observers(), "Standard observer");
  add_exposure(app, *command);
  CLI::Option* format = add_choice(app, "--format", command->format, formats, "Form of the output");
  add_texts(app, "-o,--output", command->outputs, "FILE",
            "Chart or table to write instead, .png, .svg or .csv; may be repeated")
      ->excludes(format);
  std::string list;
  for (const desk::Shortcut& shortcut : desk::shortcuts())
    list += fmt::format("  {:<18} {}\n", shortcut.name, shortcut.description);
  app.footer(std::string(stack_help) + "\nShortcuts:\n" + list + R"(
Each is compared with the exact colour, thickness by thickness: all reflections, both polarisations, dispersion, 360 to
830 nm at 1 nm, or means over each nanometre where fringes are finer. Differences are CIEDE2000; the white of Lab is the
lamp. Only STACK's layer --layer changes.

Examples:
  shabon compare 'air | water 0nm | air'
  shabon compare 'air | water 0nm | air' --angle 60 --exposure fit -o bubble.png
  shabon compare 'air | oleic-acid 0nm | water' --thickness 0:1um:2nm --format csv > oil.csv
  shabon compare 'air | MgF2 0nm | ZnS 60nm | glass' --layer 1 --illuminant FL11)");
  return [command] { return run_compare(*command); };
}

}  // namespace shabon::app
