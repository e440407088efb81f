#include "command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "shabon/api/version.h"
#include "shabon/base/text.h"
#include "streams.h"

namespace shabon::app {

namespace {

constexpr std::array command_list{
    Command{"render", "Render a scene to a picture", declare_render},
    Command{"probe", "The spectrum that arrives along one ray", declare_probe},
    Command{"spectrum", "Reflectance and transmittance of a film over wavelength and angle", declare_spectrum},
    Command{"color", "The colour of a film under a lamp", declare_color},
    Command{"media", "List the media of the library", declare_media},
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
  for (const Command& command : command_list) names.push_back(command.name);
  return names;
}

int complain(const std::string& message, const std::string& command) {
  report(fail(Failure::usage, message));
  say(fmt::format("Run 'shabon {}--help' for what it takes.", command.empty() ? "" : command + " "));
  return static_cast<int>(Failure::usage);
}

// "-.5" would be taken for an option, and "--exposure=" would take the next argument as its value.
Action prepared(std::vector<std::string>& arguments) {
  for (std::string& argument : arguments) {
    if (argument == "--") break;
    if (argument.starts_with("-.") && parse_number(argument)) argument.insert(1, "0");
    if (argument.starts_with("--") && argument.ends_with("=") && argument.find('=') + 1 == argument.size())
      return [argument] { return complain(printable(argument, 60) + " lacks a value", ""); };
  }
  return {};
}

std::string unexpected(const CLI::App& app, const std::string& argument) {
  if (argument.size() < 2 || argument[0] != '-')
    return fmt::format("unexpected argument '{}'; an argument with blanks or '|' needs quotes",
                       printable(argument, 60));
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options({}))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::vector<std::string_view> known(names.begin(), names.end());
  return unknown_name("option", argument.substr(0, argument.find('=')), known);
}

// CLI11's messages, where they can be clearer.
std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  // An unknown option may leave a required argument missing: then it is the one to name.
  const bool names_one = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                         dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (names_one)
    for (const std::string& argument : app.remaining())
      if (argument != "--") return unexpected(app, argument);
  return error.what();
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

}  // namespace

std::span<const Command> commands() { return command_list; }

Action chosen_action(std::vector<std::string> arguments) {
  if (Action complaint = prepared(arguments)) return complaint;
  CLI::App app("Shabon computes and renders the colours that light interference makes.", "shabon");
  app.footer(examples);
  app.formatter(std::make_shared<HelpText>());
  app.require_subcommand(1);
  app.set_version_flag("-V,--version", "shabon " + std::string(version()), "Print the version and exit");
  add_help(app);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
    add_help(*sub);
    actions.emplace_back(sub, command.declare(*sub));
  }

  if (arguments.empty()) return [] { return complain("a command is needed", ""); };
  const std::vector<std::string_view> names = command_names();
  const std::string& first = arguments.front();
  if (!first.starts_with("-") && std::find(names.begin(), names.end(), first) == names.end())
    return [text = unknown_name("command", first, names)] { return complain(text, ""); };

  const CLI::App* chosen = &app;
  for (const auto& [sub, action] : actions)
    if (sub->get_name() == first) chosen = sub;
  try {
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    return [text = app.help()] { return print_result(text); };
  } catch (const CLI::CallForVersion& asked) {
    return [text = std::string(asked.what()) + "\n"] { return print_result(text); };
  } catch (const CLI::ParseError& error) {
    const std::string name = chosen == &app ? "" : chosen->get_name();
    return [text = message_of(*chosen, error), name] { return complain(text, name); };
  }
  for (const auto& [sub, action] : actions)
    if (sub->parsed()) return action;
  return [] { return complain("a command is needed", ""); };
}

}  // namespace shabon::app
