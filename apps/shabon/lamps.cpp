// shabon lamps: the lamps and observers of the library with their sources; shabon lamps NAME...: spectra, x and y, CCT.
#include <fmt/format.h>

#include <memory>

#include "chart_files.h"
#include "command.h"
#include "lamp_table.h"
#include "options.h"
#include "picture_files.h"
#include "shabon/api/resolvers.h"
#include "shabon/base/text.h"
#include "streams.h"
#include "wavelengths.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_lamps = 1000, most_values = 10'000'000;

struct Format {
  std::string_view name;
  std::string (*list)();
  std::string (*table)(const LampTable&);
};

constexpr Format formats[] = {{"text", lamp_list_text, lamp_table_text},
                              {"csv", lamp_list_csv, lamp_table_csv},
                              {"json", lamp_list_json, lamp_table_json}};

struct LampOptions {
  std::vector<std::string> names, outputs;
  std::vector<double> wavelengths_nm;
  std::size_t format = 0, observer = 0;
  const CLI::Option *wavelengths_given = nullptr, *format_given = nullptr, *observer_given = nullptr;
};

Status check_usage(const LampOptions& options) {
  const auto refuse = [](const char* message) { return fail(Failure::usage, message); };
  if (options.names.empty() && !options.outputs.empty()) return refuse("--output: expected the names of lamps to draw");
  if (options.names.empty() && options.wavelengths_given->count() > 0)
    return refuse("--wavelengths: expected the names of lamps to print");
  if (options.names.empty() && options.observer_given->count() > 0)
    return refuse("--observer: expected the names of lamps to print");
  if (!options.outputs.empty() && options.format_given->count() > 0)
    return refuse("--format: expected without --output, whose ending tells the format");
  if (options.names.size() > most_lamps || options.names.size() * options.wavelengths_nm.size() > most_values)
    return fail(Failure::usage,
                fmt::format("at most {} lamps, and {} values of lamps times wavelengths", most_lamps, most_values));
  return Done{};
}

// What the lamps' notes say goes to `notes`, and the files that were read to `files`.
Result<LampTable> read_table(const LampOptions& options, std::vector<std::filesystem::path>& files,
                             Diagnostics& notes) {
  LampTable table{{}, options.wavelengths_nm, color::observers()[options.observer]};
  Diagnostics errors;
  for (const std::string& name : options.names) {
    if (const auto file = color::illuminant_file(name)) files.emplace_back(*file);
    Result<color::Illuminant> lamp = api::illuminant_resolver()(name);
    if (!lamp) {
      errors.insert(errors.end(), lamp.errors().begin(), lamp.errors().end());
      continue;
    }
    if (!lamp->note.empty()) notes.push_back(warning_of(lamp->note));
    table.lamps.push_back(*std::move(lamp));
  }
  if (!errors.empty()) return errors;
  return table;
}

int draw(const LampTable& table, const std::vector<ChartFile>& files) {
  const MadeChart chart{lamp_chart(table), lamp_table_csv(table), {}};
  for (const ChartFile& file : files) {
    if (const Status written = write_chart(file, chart, {}); !written) return report(written.errors());
    say(fmt::format("wrote {}", printable(file.path.string())));
  }
  return success;
}

int run_lamps(const LampOptions& options) {
  if (const Status usage = check_usage(options); !usage) return report(usage.errors());
  if (options.names.empty()) return print_result(formats[options.format].list());
  const Result<std::vector<ChartFile>> files = chart_files(options.outputs);
  if (!files) return report(files.errors());
  std::vector<std::filesystem::path> outputs, inputs;
  for (const ChartFile& file : *files) outputs.push_back(file.path);
  Diagnostics notes;
  const Result<LampTable> table = read_table(options, inputs, notes);
  if (!table) return report(table.errors());
  if (const Status writable = check_outputs(outputs, inputs); !writable) return report(writable.errors());
  report(notes);
  return files->empty() ? print_result(formats[options.format].table(*table)) : draw(*table, *files);
}

}  // namespace

Action declare_lamps(CLI::App& app) {
  const auto options = std::make_shared<LampOptions>();
  app.add_option("NAME", options->names, "Lamps whose spectra to print or draw; without any, the library is listed")
      ->type_name("");
  // Fluorescent lamps have lines: fewer wavelengths would miss them.
  add_wavelengths(app, options->wavelengths_nm, "360:830:1", {.low = color::first_nm, .high = color::last_nm});
  options->wavelengths_given = app.get_option("--wavelengths");
  options->observer_given =
      add_choice(app, "--observer", options->observer, color::observers(), "Standard observer of x and y");
  options->format_given = add_choice(app, "--format", options->format, formats, "Form of the output");
  add_texts(app, "-o,--output", options->outputs, "FILE", "Draws the spectra: .svg or .png, or .csv; may be repeated");
  app.footer(
      R"(A lamp is a name of the library in any case (F11 is FL11), blackbody:3000K (1000 to 100000 K), daylight:5000K (4000 to
25000 K), or file:PATH: a CSV with the columns wavelength_nm and power, linear between its samples and zero beyond them. Powers are relative. x and y are
the chromaticity; the correlated colour temperature (CCT) and the distance from the blackbodies (Duv) are those of 1931.

Examples:
  shabon lamps
  shabon lamps F11 --wavelengths 400:700:10
  shabon lamps A blackbody:2856K daylight:5000K -o lamps.svg
  shabon lamps file:lamp.csv --format json)");
  return [options] { return run_lamps(*options); };
}

}  // namespace shabon::app
