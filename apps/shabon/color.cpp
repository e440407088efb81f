// shabon color STACK: the colour of a film under a lamp.
#include <fmt/format.h>

#include <memory>

#include "color_report.h"
#include "command.h"
#include "lamp_input.h"
#include "options.h"
#include "stack_input.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_angles = 10'000;

struct ColorCommand {
  StackInput stack;
  std::vector<double> incidence_deg{0};
  std::string lamp = "D65";
  std::size_t observer = 0, mapping = 0, format = 0;
  std::optional<color::Adaptation> adaptation;
  std::vector<std::string> spaces;
  bool reflected = false, transmitted = false;
};

struct Format {
  std::string_view name;
  std::string (*write)(const ColorReport&);
};

constexpr Format formats[] = {{"text", color_text}, {"json", color_json}, {"csv", color_csv}, {"svg", color_svg}};

std::vector<color::ColorSpace> spaces_of(const ColorCommand& command) {
  std::vector<color::ColorSpace> spaces;
  for (const std::string& name : command.spaces) spaces.push_back(*color::find_color_space(name));
  return spaces;
}

std::vector<desk::Side> sides_of(const ColorCommand& command) {
  std::vector<desk::Side> sides;
  if (command.reflected || !command.transmitted) sides.push_back(desk::Side::reflected);
  if (command.transmitted) sides.push_back(desk::Side::transmitted);
  return sides;
}

int run_color(const ColorCommand& command) {
  const Result<optics::Stack> stack = read_stack(command.stack);
  if (!stack) return report(stack.errors());
  const Result<color::Illuminant> lamp = read_lamp(command.lamp);
  if (!lamp) return report(lamp.errors());
  const color::Observer& observer = color::observers()[command.observer];
  const color::Xyz white = color::white_point(*lamp, observer);

  ColorReport result{command.stack.expression,
                     command.stack.interference(),
                     command.stack.reversed,
                     lamp->name,
                     observer.name,
                     {},
                     spaces_of(command),
                     {}};
  result.options.mapping = color::gamut_mappings()[command.mapping].mapping;
  result.options.adaptation = command.adaptation;

  report(desk::range_warnings(*stack, std::vector<double>{color::first_nm, color::last_nm}));
  report(power_notes(*stack, command.transmitted));
  for (const double incidence_deg : command.incidence_deg) {
    for (const desk::Side side : sides_of(command)) {
      const color::Spectrum share =
          desk::unpolarised(*stack, command.stack.interference(), optics::incidence_from(Degrees(incidence_deg)), side);
      FilmColor& film = result.colors.emplace_back();
      film = {incidence_deg, side, desk::color_of(share, *lamp, observer, result.options), {}};
      for (const color::ColorSpace space : result.spaces)
        film.in_spaces.push_back(desk::in_space(space, film.color.xyz, white, result.options.adaptation));
    }
  }
  return print_result(formats[command.format].write(result));
}

void add_spaces(CLI::App& app, std::vector<std::string>& target) {
  const std::string option = "--space";
  std::string known;
  for (const color::ColorSpaceEntry& entry : color::color_spaces())
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  const auto read = [&target, option](const std::vector<std::string>& names) {
    target.clear();
    for (const std::string& text : names) {
      for (const std::string_view name : split(text, ',')) {
        std::vector<std::string_view> list;
        for (const color::ColorSpaceEntry& entry : color::color_spaces()) list.push_back(entry.name);
        if (!color::find_color_space(trim(name))) usage_error(option, unknown_name("colour space", trim(name), list));
        target.emplace_back(trim(name));
      }
    }
  };
  app.add_option_function<std::vector<std::string>>(
         option, read, "Also the components in this space; a list or repeated: " + known + ". RGB is linear light")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

Action declare_color(CLI::App& app) {
  const auto command = std::make_shared<ColorCommand>();
  add_stack_input(app, command->stack);
  add_numbers(app, "--angle", command->incidence_deg, {.low = 0, .high = 90}, "degrees", most_angles,
              "Angles of incidence in the first medium, 0..90 degrees: 30 or 0,30,60; may be repeated [0]");
  add_lamp(app, command->lamp);
  add_choice(app, "--observer", command->observer, color::observers(), "Standard observer");
  app.add_flag("--reflected", command->reflected, "The reflected light; the default");
  app.add_flag("--transmitted", command->transmitted, "The transmitted light; with --reflected both");
  add_spaces(app, command->spaces);
  add_adaptation(app, command->adaptation, "Chromatic adaptation of RGB and Oklab from the lamp's white");
  for (std::size_t i = 0; i < color::gamut_mappings().size(); ++i)
    if (color::gamut_mappings()[i].mapping == desk::ColorOptions{}.mapping) command->mapping = i;
  add_choice(app, "--gamut", command->mapping, color::gamut_mappings(), "How 'mapped' is brought into sRGB");
  add_choice(app, "--format", command->format, formats, "Form of the output");
  app.footer(std::string(stack_help) + R"(
The light is unpolarised. Y of the perfect reflector is 1; the white of Lab is the lamp. 'clipped' cuts each component
of linear sRGB to 0..1, 'mapped' keeps the hue and gives up chroma, and a little lightness, until it lies inside. XYZ,
xy and Lab are never adapted.

Examples:
  shabon color 'air | water 300nm | air'
  shabon color 'air | water 300nm | air' --angle 0,30,60 --illuminant blackbody:2700K --adaptation bradford
  shabon color 'air | TiO2 60nm | Ti' --space 'Display P3,Oklab' --format json
  shabon color '1 | 1.38 99.6nm | 1.52' --reflected --transmitted --format svg > card.svg)");
  return [command] { return run_color(*command); };
}

}  // namespace shabon::app
