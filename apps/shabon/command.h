// The list of the subcommands. Each lives in a file of its own; a new one is added to the list in command.cpp.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shabon::app {

using Action = std::function<int()>;  // what a command does; returns the exit code

struct Command {
  std::string_view name, summary;
  Action (*declare)(CLI::App& app);  // adds the options to `app`; the action reads them after the parse
};

std::span<const Command> commands();

Action declare_render(CLI::App& app);
Action declare_probe(CLI::App& app);
Action declare_simulate(CLI::App& app);
Action declare_animate(CLI::App& app);
Action declare_spectrum(CLI::App& app);
Action declare_color(CLI::App& app);
Action declare_chart(CLI::App& app);
Action declare_thickness(CLI::App& app);
Action declare_compare(CLI::App& app);
Action declare_reference(CLI::App& app);
Action declare_media(CLI::App& app);
Action declare_lamps(CLI::App& app);

// The action that the arguments (without the program's name) ask for: a command, its help, or a complaint.
Action chosen_action(std::vector<std::string> arguments);

}  // namespace shabon::app
