// shabon spectrum STACK: R, T and A per polarisation over wavelength and angle.
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "options.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/film_table.h"
#include "spectrum_chart.h"
#include "spectrum_table.h"
#include "stack_input.h"
#include "streams.h"
#include "wavelengths.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_angles = 100'000;
constexpr std::size_t most_values = 20'000'000;

struct Format {
  std::string_view name;
  std::string (*write)(const SpectrumTable&);
};

constexpr Format formats[] = {
    {"csv", spectrum_csv}, {"text", spectrum_text}, {"json", spectrum_json}, {"svg", spectrum_svg}};

struct SpectrumOptions {
  StackInput stack;
  std::vector<double> incidence_deg{0};
  std::vector<double> wavelengths_nm;
  desk::FilmTableDetails details;
  std::size_t format = 0;
};

int run_spectrum(const SpectrumOptions& options) {
  const Result<optics::Stack> stack = read_stack(options.stack);
  if (!stack) return report(stack.errors());
  const std::size_t columns = desk::film_table_columns(*stack, options.details);
  if (options.incidence_deg.size() * options.wavelengths_nm.size() > most_values / columns)
    return report(fail(Failure::usage, fmt::format("at most {} values, angles times wavelengths times {} columns",
                                                   most_values, columns)));

  report(desk::range_warnings(*stack, options.wavelengths_nm));
  report(power_notes(*stack, false));
  Result<desk::FilmTable> film = desk::film_table(*stack, options.stack.interference(), options.incidence_deg,
                                                  options.wavelengths_nm, options.details);
  if (!film) return report(film.errors());
  return print_result(formats[options.format].write(
      {options.stack.expression, options.stack.interference(), options.stack.reversed, std::move(*film)}));
}

}  // namespace

Action declare_spectrum(CLI::App& app) {
  const auto options = std::make_shared<SpectrumOptions>();
  add_stack_input(app, options->stack);
  add_numbers(app, "--angle", options->incidence_deg, {.low = 0, .high = 90}, "degrees", most_angles,
              "Angles of incidence in the first medium, 0..90 degrees: 30 or 0,30,60; may be repeated [0]");
  add_wavelengths(app, options->wavelengths_nm, "360:830:5", {.low = 0, .high = 1e9, .low_open = true});
  app.add_flag("--amplitudes", options->details.amplitudes,
               "Adds the complex r and t of s and p, and their phases in degrees");
  app.add_flag("--ellipsometry", options->details.ellipsometry,
               "Adds psi and Delta in degrees, of the reflected (psi_deg) and of the transmitted light (psi_t_deg)");
  app.add_flag("--layers", options->details.layers, "Adds what each layer absorbs: A_s_1, A_p_1, ...");
  add_choice(app, "--format", options->format, formats, "Form of the output");
  app.footer(std::string(stack_help) + R"(
Columns: wavelength_nm,R_s,R_p,T_s,T_p,A_s,A_p; with several angles angle_deg comes first. A = 1 - R - T.
r and t are ratios of electric fields for the time factor e^(-iwt), r_p = -r_s at normal incidence; t at the last
interface. tan(psi) e^(i Delta) = r_p/r_s in the sense of instruments, e^(+iwt).

Examples:
  shabon spectrum 'air | water 300nm | air' --angle 45
  shabon spectrum '1 | 1.38 99.6nm | 1.52' --wavelengths 550
  shabon spectrum 'air | water 0.4um | air' --angle 0,30,60 --format svg > film.svg
  shabon spectrum 'air | SiO2 25nm | Si' --angle 70 --ellipsometry --format text
  shabon spectrum 'air | (ZnS 58nm | MgF2 99nm)^5 | Ag 40nm | glass' --layers --reverse
  shabon spectrum 'air | file:oil.csv 250nm | water' --wavelengths 400:700:1 --format json)");
  return [options] { return run_spectrum(*options); };
}

}  // namespace shabon::app
