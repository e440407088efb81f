#include "lamp_input.h"

#include <fmt/format.h>

#include "options.h"
#include "shabon/api/resolvers.h"
#include "streams.h"

namespace shabon::app {

namespace {
const std::string option = "--illuminant";
}

void add_lamp(CLI::App& app, std::string& target) {
  app.add_option_function<std::string>(
         option, [&target](const std::string& text) { target = text; },
         "Lamp: " + color::illuminant_forms() + ", or file:PATH of one's own [" + target + "]")
      ->type_name("NAME");
}

Result<color::Illuminant> read_lamp(const std::string& text) {
  Result<color::Illuminant> lamp = api::illuminant_resolver()(text);
  if (!lamp) {
    Diagnostics errors = lamp.errors();
    for (Diagnostic& error : errors)
      if (error.source.empty() && error.key.empty()) error.key = option;
    return errors;
  }
  if (!lamp->note.empty()) report({warning_of(lamp->name + ": " + lamp->note)});
  return lamp;
}

CLI::Option* add_adaptation(CLI::App& app, std::optional<color::Adaptation>& target, const std::string& description) {
  std::vector<std::string_view> names = {"none"};
  for (const color::AdaptationEntry& entry : color::adaptations()) names.push_back(entry.name);
  const auto read = [&target, names](const std::string& text) {
    target = color::find_adaptation(text);
    if (!target && !same_name(text, "none")) usage_error("--adaptation", unknown_name("value", text, names));
  };
  return app
      .add_option_function<std::string>("--adaptation,--adapt", read,
                                        fmt::format("{}: {} [none]", description, fmt::join(names, ", ")))
      ->type_name("NAME");
}

}  // namespace shabon::app
