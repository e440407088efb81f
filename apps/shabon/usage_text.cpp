#include "usage_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "shabon/base/text.h"

namespace shabon::app {

namespace {

constexpr std::size_t most_shown = 60;  // characters of an argument

std::string quoted(const std::string& argument) { return "'" + printable(argument, most_shown) + "'"; }

// "'1' and '2'"
std::string quoted(const std::vector<std::string>& arguments) {
  std::string text;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    text += (i == 0 ? "" : i + 1 == arguments.size() ? " and " : ", ") + quoted(arguments[i]);
  return text;
}

template <class Kind>
bool is(const CLI::ParseError& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

// CLI11's errors carry no option, but their texts begin with its name; that of a flag lacks the dashes.
const CLI::Option* option_named_first(const CLI::App& app, std::string_view text) {
  const std::string first(text.substr(0, text.find_first_of(": ")));
  for (const CLI::Option* option : app.get_options({}))
    if (option->get_name() == first || option->get_name() == "--" + first) return option;
  return nullptr;
}

std::string unexpected(const CLI::App& app, bool is_command, const std::string& argument) {
  if (argument.size() < 2 || argument[0] != '-')
    return "unexpected argument " + quoted(argument) + "; an argument with blanks or '|' needs quotes";
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options({}))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::string name = argument.substr(0, argument.find('='));
  if (std::find(names.begin(), names.end(), name) != names.end())
    return name + " stands after '--', where no option is";
  const std::vector<std::string_view> known(names.begin(), names.end());
  return unknown_name("option", name, known) + (is_command ? "" : "; the options of a command stand after its name");
}

// Too few values of an option, or too many.
std::string wrong_count(const CLI::Option& option) {
  const std::string name = option.get_name(), form = option.get_type_name();
  const std::vector<std::string>& given = option.results();
  if (option.get_items_expected_max() == 0) return name + ": expected no value";
  const auto wanted = static_cast<std::size_t>(std::max(1, option.get_items_expected_min()));
  if (given.empty()) return fmt::format("{}: expected {} after it, got nothing", name, form);
  if (given.size() < wanted) return fmt::format("{}: expected {}, got only {}", name, form, quoted(given));
  return fmt::format("{}: expected {} once, got {}", name, form, quoted(given));
}

}  // namespace

std::string usage_text(const CLI::App& root, const CLI::App& chosen, const CLI::ParseError& error) {
  std::string text = error.what();
  if (is<CLI::ValidationError>(error)) return text;  // of usage_error()
  const bool missing = is<CLI::RequiredError>(error);
  // An unknown option may leave a required argument missing: then it is the one to name.
  if (missing || is<CLI::ExtrasError>(error))
    for (const std::string& argument : root.remaining(true))
      if (argument != "--") return unexpected(chosen, &chosen != &root, argument);
  const CLI::Option* option = option_named_first(chosen, text);
  if (option == nullptr) return "the arguments cannot be understood";
  const std::string name = option->get_name();
  if (missing) return fmt::format("expected {}: {}", name, option->get_description());
  if (is<CLI::ArgumentMismatch>(error)) return wrong_count(*option);
  if (is<CLI::ExcludesError>(error))
    for (const CLI::Option* other : option->get_excludes())
      if (other->count() > 0) return fmt::format("expected only one of {} and {}, got both", name, other->get_name());
  return name + ": the value cannot be understood";
}

}  // namespace shabon::app
