// shabon spectrum STACK: R, T and A per polarisation over wavelength and angle.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "json.h"
#include "options.h"
#include "shabon/desk/film_spectrum.h"
#include "spectrum_chart.h"
#include "spectrum_table.h"
#include "stack_input.h"
#include "streams.h"
#include "wavelengths.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_angles = 100'000;
constexpr std::size_t most_rows = 2'000'000;

struct Format {
  std::string_view name;
  std::string (*write)(const SpectrumTable&);
};

constexpr Format formats[] = {{"csv", spectrum_csv}, {"json", spectrum_json}, {"svg", spectrum_svg}};

struct SpectrumOptions {
  StackInput stack;
  std::vector<double> incidence_deg{0};
  std::vector<double> wavelengths_nm;
  std::size_t format = 0;
};

int run_spectrum(const SpectrumOptions& options) {
  SpectrumTable table;
  table.expression = options.stack.expression;
  table.interference = options.stack.interference();
  table.incidence_deg = options.incidence_deg;
  table.wavelengths_nm = options.wavelengths_nm;
  if (table.incidence_deg.size() * table.wavelengths_nm.size() > most_rows)
    return report(fail(Failure::usage, fmt::format("at most {} rows, angles times wavelengths", most_rows)));

  const Result<optics::Stack> stack = read_stack(options.stack);
  if (!stack) return report(stack.errors());
  report(desk::range_warnings(*stack, table.wavelengths_nm));
  fill(table, *stack);
  return print_result(formats[options.format].write(table));
}

}  // namespace

Action declare_spectrum(CLI::App& app) {
  const auto options = std::make_shared<SpectrumOptions>();
  add_stack_input(app, options->stack);
  add_numbers(app, "--angle", options->incidence_deg, {.low = 0, .high = 90}, "degrees", most_angles,
              "Angles of incidence in the first medium, 0..90 degrees: 30 or 0,30,60; may be repeated [0]");
  add_wavelengths(app, options->wavelengths_nm, "360:830:5", {.low = 0, .high = 1e9, .low_open = true});
  add_choice(app, "--format", options->format, formats, "Form of the output");
  app.footer(std::string(stack_help) + R"(
Columns: wavelength_nm,R_s,R_p,T_s,T_p,A_s,A_p; with several angles angle_deg comes first. A = 1 - R - T.

Examples:
  shabon spectrum 'air | water 300nm | air' --angle 45
  shabon spectrum '1 | 1.38 99.6nm | 1.52' --wavelengths 550
  shabon spectrum 'air | water 0.4um | air' --angle 0,30,60 --format svg > film.svg
  shabon spectrum 'air | file:oil.csv 250nm | water' --wavelengths 400:700:1 --format json)");
  return [options] { return run_spectrum(*options); };
}

}  // namespace shabon::app
