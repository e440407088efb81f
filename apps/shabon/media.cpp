// shabon media: the media of the library with their ranges and sources; shabon media NAME...: n and k over wavelength.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "chart_files.h"
#include "command.h"
#include "media_list.h"
#include "media_table.h"
#include "options.h"
#include "picture_files.h"
#include "shabon/api/resolvers.h"
#include "shabon/optics/stack_expression.h"
#include "streams.h"
#include "wavelengths.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_media = 1000, most_values = 10'000'000;

struct Format {
  std::string_view name;
  std::string (*list)();
  std::string (*table)(const MediaTable&);
};

constexpr Format formats[] = {{"text", media_list_text, media_table_text},
                              {"csv", media_list_csv, media_table_csv},
                              {"json", media_list_json, media_table_json}};

struct MediaOptions {
  std::vector<std::string> names, outputs;
  std::vector<double> wavelengths_nm;
  std::size_t format = 0;
  const CLI::Option *wavelengths_given = nullptr, *format_given = nullptr;
};

Status check_usage(const MediaOptions& options) {
  const auto refuse = [](const char* message) { return fail(Failure::usage, message); };
  if (options.names.empty() && !options.outputs.empty()) return refuse("--output: expected the names of media to draw");
  if (options.names.empty() && options.wavelengths_given->count() > 0)
    return refuse("--wavelengths: expected the names of media to print");
  if (!options.outputs.empty() && options.format_given->count() > 0)
    return refuse("--format: expected without --output, whose ending tells the format");
  if (options.names.size() > most_media || options.names.size() * options.wavelengths_nm.size() > most_values)
    return fail(Failure::usage,
                fmt::format("at most {} media, and {} values of media times wavelengths", most_media, most_values));
  return Done{};
}

Result<MediaTable> read_table(const MediaOptions& options, std::vector<std::filesystem::path>& files) {
  MediaTable table{{}, options.wavelengths_nm};
  Diagnostics errors;
  const optics::MediumResolver resolver = api::medium_resolver();
  const auto noting = [&](std::string_view name, bool is_file) {
    if (is_file) files.emplace_back(name);
    return resolver(name, is_file);
  };
  for (const std::string& name : options.names) {
    Result<optics::Medium> medium = optics::parse_medium(name, noting);
    if (medium)
      table.media.push_back(std::move(*medium));
    else
      errors.insert(errors.end(), medium.errors().begin(), medium.errors().end());
  }
  if (!errors.empty()) return errors;
  return table;
}

// One warning a medium.
Diagnostics range_warnings(const MediaTable& table) {
  Diagnostics warnings;
  for (std::size_t i = 0; i < table.media.size(); ++i) {
    bool repeated = false;
    for (std::size_t j = 0; j < i; ++j) repeated = repeated || table.media[j] == table.media[i];
    std::string note = table.media[i].outside_range_note(table.wavelengths_nm);
    if (!repeated && !note.empty()) warnings.push_back(warning_of(std::move(note)));
  }
  return warnings;
}

int draw(const MediaTable& table, const std::vector<ChartFile>& files) {
  const MadeChart chart{media_chart(table), media_table_csv(table), {}};
  for (const ChartFile& file : files) {
    if (const Status written = write_chart(file, chart, {}); !written) return report(written.errors());
    say(fmt::format("wrote {}", printable(file.path.string())));
  }
  return success;
}

int run_media(const MediaOptions& options) {
  if (const Status usage = check_usage(options); !usage) return report(usage.errors());
  if (options.names.empty()) return print_result(formats[options.format].list());
  const Result<std::vector<ChartFile>> files = chart_files(options.outputs);
  if (!files) return report(files.errors());
  std::vector<std::filesystem::path> outputs, inputs;
  for (const ChartFile& file : *files) outputs.push_back(file.path);
  const Result<MediaTable> table = read_table(options, inputs);
  if (!table) return report(table.errors());
  if (const Status writable = check_outputs(outputs, inputs); !writable) return report(writable.errors());
  report(range_warnings(*table));
  return files->empty() ? print_result(formats[options.format].table(*table)) : draw(*table, *files);
}

}  // namespace

Action declare_media(CLI::App& app) {
  const auto options = std::make_shared<MediaOptions>();
  app.add_option("NAME", options->names, "Media whose n and k to print or draw; without any, the library is listed")
      ->type_name("");
  add_wavelengths(app, options->wavelengths_nm, "360:830:5", {.low = 0, .high = 1e9, .low_open = true});
  options->wavelengths_given = app.get_option("--wavelengths");
  options->format_given = add_choice(app, "--format", options->format, formats, "Form of the output");
  add_texts(app, "-o,--output", options->outputs, "FILE", "Draws n and k: .svg or .png, or .csv; may be repeated");
  app.footer(
      R"(A medium is a name of the library in any case, an index such as 2.4+0.01i, file:PATH, or a mixture by volume.
An n-k file is a .yml of refractiveindex.info, or CSV with these columns in any order and case:
  wavelength in nm  wavelength_nm, lambda_nm, wave_nm, wl_nm, nm, wavelength, lambda
  wavelength in um  wavelength_um, lambda_um, wave_um, wl_um, um, wavelength_micron, wl
  n                 n, index, refractive_index
  k, if it absorbs  k, kappa, extinction, extinction_coefficient
';' or tabs may separate them, and then ',' is a decimal point; two tables, wl,n above wl,k, are joined.
Beyond its range a formula is continued over 360..830 nm and then held; a table holds its end value; a warning says so.

Examples:
  shabon media
  shabon media SiO2 TiO2 --wavelengths 400:700:50
  shabon media Ag Au Cu -o metals.svg
  shabon media 'mix(water 70%, glycerol 30%)' --format csv
  shabon media file:oil.csv --wavelengths 589.3 --format json)");
  return [options] { return run_media(*options); };
}

}  // namespace shabon::app
