#include "command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "shabon/api/version.h"
#include "shabon/base/text.h"
#include "streams.h"
#include "usage_text.h"

namespace shabon::app {

namespace {

constexpr std::array command_list{
    Command{"render", "Render a scene to a picture", declare_render},
    Command{"probe", "The spectrum that arrives along one ray", declare_probe},
    Command{"animate", "Render a range of frames, and a movie of them", declare_animate},
    Command{"simulate", "The living film: thickness that flows and drains", declare_simulate},
    Command{"spectrum", "Reflectance and transmittance of a film over wavelength and angle", declare_spectrum},
    Command{"color", "The colour of a film under a lamp", declare_color},
    Command{"chart", "Draw charts of film colours and of birefringence", declare_chart},
    Command{"thickness", "From a colour or a measured spectrum back to the thickness", declare_thickness},
    Command{"compare", "How far common shortcuts are from the exact colour of a film", declare_compare},
    Command{"reference", "Write tables of standard films, to test other programs against", declare_reference},
    Command{"media", "List the media of the library, print and draw their n and k", declare_media},
    Command{"lamps", "List the lamps and observers of the library", declare_lamps},
};

constexpr const char* examples = R"(Examples:
  shabon render                                     the built-in bubble as bubble.png
  shabon render scenes/bubble/scene.yaml -o a.png -o a.exr
  shabon spectrum 'air | water 300nm | air' --angle 45
  shabon color 'air | water 300nm | air' --illuminant A

'shabon COMMAND --help' tells all about a command. Exit codes: 0 fine, 2 usage, 3 content, 4 file, 5 internal,
130 and 143 interrupted.)";

std::vector<std::string_view> command_names() {
  std::vector<std::string_view> names;
  names.reserve(command_list.size());
  for (const Command& command : command_list) names.push_back(command.name);
  return names;
}

int complain(const std::string& message, const std::string& command) {
  report(fail(Failure::usage, message));
  say(fmt::format("Run 'shabon {}--help' for what it takes.", command.empty() ? "" : command + " "));
  return static_cast<int>(Failure::usage);
}

// The text of the complaint about an argument such as "--exposure=", which would take the next one as its value;
// otherwise empty. "-.5", which would be taken for an option, becomes "-0.5".
std::string prepared(std::vector<std::string>& arguments) {
  for (std::string& argument : arguments) {
    if (argument == "--") break;
    if (argument.starts_with("-.") && parse_number(argument)) argument.insert(1, "0");
    if (argument.starts_with("--") && argument.find('=') + 1 == argument.size())
      return fmt::format("{}: expected a value after '=', got nothing",
                         printable(argument.substr(0, argument.size() - 1), 60));
  }
  return {};
}

// After an option only the form of its value; CLI11 would add how many there are.
class HelpText : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string form = option->get_type_name();
    return form.empty() ? "" : " " + form;
  }
};

void add_help(CLI::App& app) { app.set_help_flag("-h,--help", "Print this help and exit"); }

// --quiet=7 is no way to say --quiet.
void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_items_expected_max() == 0; }))
    option->disable_flag_override();
}

using Actions = std::vector<std::pair<const CLI::App*, Action>>;

// Adds all commands and what stands beside them.
Actions declare_all(CLI::App& app) {
  app.footer(examples);
  app.formatter(std::make_shared<HelpText>());
  app.require_subcommand(1);
  app.set_version_flag("-V,--version", "shabon " + std::string(version()), "Print the version and exit");
  add_help(app);
  Actions actions;
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
    add_help(*sub);
    actions.emplace_back(sub, command.declare(*sub));
    refuse_values_of_flags(*sub);
  }
  return actions;
}

}  // namespace

std::span<const Command> commands() { return command_list; }

Action chosen_action(std::vector<std::string> arguments) {
  CLI::App app("Shabon computes and renders the colours that light interference makes.", "shabon");
  const Actions actions = declare_all(app);

  if (arguments.empty() || arguments.front() == "--") return [] { return complain("a command is needed", ""); };
  const std::vector<std::string_view> names = command_names();
  const std::string first = arguments.front();
  const bool is_command = std::find(names.begin(), names.end(), first) != names.end();
  if (!first.starts_with("-") && !is_command)
    return [text = unknown_name("command", first, names)] { return complain(text, ""); };
  const std::string name = is_command ? first : "";
  if (const std::string text = prepared(arguments); !text.empty()) return [text, name] { return complain(text, name); };

  const CLI::App& chosen = is_command ? *app.get_subcommand(first) : app;
  try {
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    return [text = app.help()] { return print_result(text); };
  } catch (const CLI::CallForVersion& asked) {
    return [text = std::string(asked.what()) + "\n"] { return print_result(text); };
  } catch (const CLI::ParseError& error) {
    return [text = usage_text(app, chosen, error), name] { return complain(text, name); };
  }
  for (const auto& [sub, action] : actions)
    if (sub == &chosen) return action;
  return [] { return complain("a command is needed", ""); };
}

}  // namespace shabon::app
